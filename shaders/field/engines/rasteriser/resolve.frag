#version 450 core
// Exact closest point, signed distance and site from the site id that the depth test left.
//
// in   closestSite   R32I atlas of site ids, -1 where there was no polygon
// out  displacement  xyz: vector to the closest point; w: signed distance; local units
//      site          the site whose interior contains the closest point; -1 if none
//      holes         number of grid points without a site
#include "../device/mesh.glsl"
#include "../device/faces.glsl"
#include "../device/closest_point.glsl"

layout(std430, binding = 3) readonly buffer Normals { vec4 normals[]; }; // pseudonormals of all sites
layout(std430, binding = 4) buffer Holes { uint holes; };

uniform isampler2D closestSite;
uniform ivec2 sliceSize;  // grid points of a slice
uniform int columns;      // slots of the atlas in a row
uniform int firstSlot;    // slots [firstSlot, endSlot) are in use
uniform int endSlot;
uniform dvec3 exactFirst; // grid point in pixel (0,0) of slot 0, local coordinates
uniform dvec3 exactSpacing;
uniform bool hasNormals;

layout(location = 0) out vec4 displacement;
layout(location = 1) out int site;

void main()
{
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  ivec2 cell = pixel / sliceSize;
  int slot = cell.y * columns + cell.x;
  if (slot < firstSlot || slot >= endSlot)
  {
    discard;
  }
  int winner = texelFetch(closestSite, pixel, 0).x;
  if (winner < 0)
  {
    atomicAdd(holes, 1u);
    displacement = vec4(0.0);
    site = -1;
    return;
  }
  dvec3 x = exactFirst + dvec3(ivec3(pixel - cell * sliceSize, slot)) * exactSpacing;
  // The bound of a face is a little too large, so the point may belong to its border.
  SitePoint closest = closestOnSite(winner, x);
  vec3 v = vec3(closest.point - x);
  float distance = length(v);
  bool inside = hasNormals && dot(normals[closest.site].xyz, v) > 0.0;
  displacement = vec4(v, inside ? -distance : distance);
  site = closest.site;
}
