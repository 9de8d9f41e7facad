#pragma once

namespace medial::benchmark
{

// These are texts here, not files: the library embeds only its own shaders.

/// What the three vertex shaders share: from a position (local units, or grid points for faces) and
/// a distance (local units) to a vertex.
constexpr char kHavocPlacement[] = R"(#version 450 core
uniform vec2 scale;
uniform vec2 offset;
uniform float depthPerUnit;
layout(location = 0) flat out int siteId;

void place(vec2 position, float distance, int site)
{
  gl_Position = vec4(position * scale + offset, 2.0 * distance * depthPerUnit - 1.0, 1.0);
  siteId = site;
}
)";

/// See FaceVertex.
constexpr char kHavocFace[] = R"(
layout(location = 0) in vec2 position;
layout(location = 1) in float distance;
layout(location = 2) in int site;

void main()
{
  place(position, distance, site);
}
)";

/// See PointInstance. Rings are evenly spaced along the hyperbola's parameter t:
/// r = height sinh t, distance = height cosh t.
constexpr char kHavocPoint[] = R"(
layout(location = 0) in vec3 node; // direction from the centre, ring as a fraction
layout(location = 1) in vec2 centre;
layout(location = 2) in float height;
layout(location = 3) in float growth;
layout(location = 4) in int site;

void main()
{
  float e = exp(node.z * growth);
  float radius = 0.5 * height * (e - 1.0 / e);
  place(centre + radius * node.xy, 0.5 * height * (e + 1.0 / e), site);
}
)";

/// See SegmentInstance. Over the plane of (w, y) every sector lies between two rays from the
/// origin, and between w = w.x and the nearer of w = w.y and y = reach.
constexpr char kHavocSegment[] = R"(
layout(location = 0) in vec3 node; // side of the line (1 or -1), ray, 0 inner or 1 outer
layout(location = 1) in vec2 from;
layout(location = 2) in vec2 to;
layout(location = 3) in vec2 across;
layout(location = 4) in vec2 w;
layout(location = 5) in float reach;
layout(location = 6) in float split;
layout(location = 7) in int site;

uniform float rays;

void main()
{
  float toAngle = atan(reach, w.y);
  float fromAngle = atan(reach, w.x);
  bool beyond = node.y > split;
  float angle = beyond
    ? mix(toAngle, fromAngle, (node.y - split) / max(rays - split, 1.0))
    : toAngle * node.y / split;
  float slope = tan(angle);
  float along = node.z;
  if (beyond && node.z > 0.0)
  {
    along = node.y < rays ? clamp((reach / slope - w.x) / max(w.y - w.x, 1e-6), 0.0, 1.0) : 0.0;
  }
  float here = mix(w.x, w.y, along);
  bool farthest = node.y == rays || (node.z > 0.0 && node.y >= split);
  float y = farthest ? reach : min(here * slope, reach);
  place(mix(from, to, along) + node.x * y * across, length(vec2(here, y)), site);
}
)";

/// The depth is the rasteriser's own.
constexpr char kHavocFragment[] = R"(#version 450 core
layout(location = 0) flat in int siteId;
layout(location = 0) out int closestSite;

void main()
{
  closestSite = siteId;
}
)";

} // namespace medial::benchmark
