#version 450 core
// Selection by separation angle (Foskey, Lin, Manocha 2003): which grid edges from a point to its +x, +y and +z
// neighbours the simplified medial axis crosses. Those of a slab's last slice wait for the slice above.
//
// in   sites      closest sites of the slice below the slab, then of the slab
// out  marks      bits of grid points; see marks.glsl
//      rowCounts  number of bits in every row
#include "numbering.glsl"
#include "axes.glsl"
#include "mesh.glsl"
#include "faces.glsl"
#include "closest_point.glsl"
#include "rows.glsl"
#include "marks.glsl"
#include "sides.glsl"

layout(local_size_x = 64) in;
layout(std430, binding = 3) readonly buffer Sites { int sites[]; };
layout(std430, binding = 5) buffer Marks { uint marks[]; };
layout(std430, binding = 6) buffer RowCounts { uint rowCounts[]; };

uniform dvec3 exactFirst; // grid point (0,0,0)
uniform dvec3 exactSpacing;
uniform ivec3 slabMin;
uniform bool carried;       // whether there is a slice below
uniform bool isLast;        // whether there is no slice above
uniform double cosineLimit; // cosine of the minimum separation angle
uniform int side;           // -1: interior, 1: exterior, 0: both

// near: from a point to its closest point; far: from its neighbour, `edge` away, to that of another site
bool isCrossed(dvec3 near, dvec3 far, dvec3 edge)
{
  double lengths = sqrt(dot(near, near) * dot(far, far));
  // If the closest points are nearer to each other than the grid points, both see the same reflex edge or the
  // same patch, not two sides.
  dvec3 gap = edge + far - near;
  return lengths > 0.0LF && dot(near, far) <= cosineLimit * lengths && dot(gap, gap) >= dot(edge, edge);
}

void main()
{
  int i = int(itemNumber());
  int row = i / slabSize.x;
  int slot = row / slabSize.y;
  ivec3 at = ivec3(i - row * slabSize.x, row - slot * slabSize.y, slot);
  if (slot >= slots || (slot == 0 && !carried) || (slot + 1 == slots && !isLast))
  {
    return;
  }
  ivec3 strides = ivec3(1, slabSize.x, slabSize.x * slabSize.y);
  ivec3 ends = ivec3(slabSize.xy, slots);
  int site = sites[i];
  if (site < 0)
  {
    return; // its tile had too little room, so the slab will be computed again
  }
  bool isKnown = false;
  bool inside = false;
  dvec3 x;
  dvec3 near;
  for (int axis = 0; axis < 3; ++axis)
  {
    int other = at[axis] + 1 < ends[axis] ? sites[i + strides[axis]] : -1;
    if (other < 0 || other == site)
    {
      continue;
    }
    if (!isKnown)
    {
      x = exactFirst + dvec3(slabMin + at - ivec3(0, 0, 1)) * exactSpacing;
      near = closestOnSite(site, x).point - x;
      inside = isInside(site, near, row, at.x);
      isKnown = true;
      if (inside)
      {
        atomicOr(marks[firstWord(row, kInside) + (at.x >> 5)], 1u << (at.x & 31));
      }
    }
    dvec3 edge = unitVector(axis) * exactSpacing;
    dvec3 far = closestOnSite(other, x + edge).point - (x + edge);
    int otherRow = row + ivec3(0, 1, slabSize.y)[axis];
    int otherX = at.x + (axis == 0 ? 1 : 0);
    bool isWanted = inside == isInside(other, far, otherRow, otherX) && (side == 0 || inside == (side < 0));
    if (isWanted && isCrossed(near, far, edge))
    {
      atomicOr(marks[firstWord(row, axis) + (at.x >> 5)], 1u << (at.x & 31));
      atomicAdd(rowCounts[row], 1u);
    }
  }
}
