#pragma once

namespace medial::benchmark
{

/// See PolygonVertex; `scaledVector` has a length in [0, 1).
constexpr char kPublishedVertex[] = R"(#version 450 core
layout(location = 0) in vec2 position;
layout(location = 1) in vec3 distance;
layout(location = 2) in int site;

uniform vec2 atlasSize;
uniform float depthScale;

layout(location = 0) out vec3 scaledVector;
layout(location = 1) flat out int siteId;

void main()
{
  scaledVector = distance * depthScale;
  siteId = site;
  gl_Position = vec4(2.0 * position / atlasSize - 1.0, 0.0, 1.0);
}
)";

/// The norm of the interpolated vector is the depth.
constexpr char kPublishedFragment[] = R"(#version 450 core
layout(location = 0) in vec3 scaledVector;
layout(location = 1) flat in int siteId;
layout(location = 0) out int closestSite;

void main()
{
  gl_FragDepth = length(scaledVector);
  closestSite = siteId;
}
)";

} // namespace medial::benchmark
