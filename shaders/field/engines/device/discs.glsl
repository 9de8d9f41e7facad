// Reads discs, and tells which of them can be near.
#include "disc.glsl"

layout(std430, binding = 1) readonly buffer Discs { vec4 discs[]; };

Disc loadDisc(int node)
{
  vec4 a = discs[kDisc * node];
  vec4 b = discs[kDisc * node + 1];
  vec4 c = discs[kDisc * node + 2];
  return Disc(a.xyz, a.w, b.xyz, b.w, c.xyz, c.w);
}

// Where a position is in relation to a disc: the distance from its centre along the axis, and from the axis.
vec2 placeOf(Disc disc, vec3 x)
{
  vec3 v = x - disc.centre;
  float along = dot(v, disc.normal);
  vec3 across = v - along * disc.normal;
  return vec2(abs(along), sqrt(dot(across, across)));
}

float squaredDistance(Disc disc, vec2 place)
{
  vec2 outside = max(place - vec2(disc.halfHeight, disc.radius), vec2(0.0));
  return dot(outside, outside);
}

// Whether Voronoi regions of the disc may come within a distance of the position.
bool meetsRegions(Disc disc, vec2 place, float within)
{
  return place.y <= disc.radius + within + (place.x + disc.halfHeight + within) * disc.slope;
}
