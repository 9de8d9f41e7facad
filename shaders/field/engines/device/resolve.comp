#version 450 core
// The exact distance and closest site of every grid point, from the element that is nearest to it.
//
// in   winners   sites that name elements
// out  values    distances, local units, negative inside; then, if they are wanted, vectors to the closest points,
//                by threes
//      sites     closest sites, after one slice of room
#include "numbering.glsl"
#include "mesh.glsl"
#include "faces.glsl"
#include "closest_point.glsl"
#include "rows.glsl"
#include "sides.glsl"

layout(local_size_x = 64) in;
layout(std430, binding = 5) readonly buffer Winners { int winners[]; };
layout(std430, binding = 6) writeonly buffer Values { float values[]; };
layout(std430, binding = 7) writeonly buffer Sites { int sites[]; };

uniform dvec3 exactFirst; // grid point (0,0,0)
uniform dvec3 exactSpacing;
uniform ivec3 slabMin;
uniform bool wantsVectors;

void main()
{
  int i = int(itemNumber());
  int count = slabSize.x * slabSize.y * slabSize.z;
  if (i >= count)
  {
    return;
  }
  int row = i / slabSize.x;
  int slice = row / slabSize.y;
  ivec3 at = ivec3(i - row * slabSize.x, row - slice * slabSize.y, slice);
  dvec3 x = exactFirst + dvec3(slabMin + at) * exactSpacing;
  int site = winners[i];
  SitePoint closest = SitePoint(-1, x);
  if (site >= 0)
  {
    closest = closestOnSite(site, x);
  }
  dvec3 v = closest.point - x;
  float away = float(length(v));
  if (closest.site >= 0 && isInside(closest.site, v, slabSize.y + row, at.x))
  {
    away = -away;
  }
  values[i] = away;
  if (wantsVectors)
  {
    values[count + 3 * i] = float(v.x);
    values[count + 3 * i + 1] = float(v.y);
    values[count + 3 * i + 2] = float(v.z);
  }
  sites[slabSize.x * slabSize.y + i] = closest.site;
}
