#version 450 core
// How far the tiles of a layer reach in which a site can be closest. One work group does a tile, with the groups that
// are left for it: of their elements it takes the parts whose Voronoi regions can hold closest points of one of the
// tile's bricks.
//
// in   elements, discs, ranges, lists  of the tiles
//      partSites                       of part_sites.comp
// out  reaches                         by fours: first grid point along x and y, and last, less that of the slab

layout(local_size_x = 64) in;
#include "../device/elements.glsl"
#include "../device/tile_groups.glsl"
#include "../device/counters.glsl"
layout(std430, binding = 5) readonly buffer PartSites { int partSites[]; };
layout(std430, binding = 6) buffer Reaches { int reaches[]; };

uniform int layer;

shared uint left;

// The parts of an element that can hold closest points, as bits.
uint partsOf(Element e, int slot)
{
  uint parts = 0u;
  for (int i = 0; i < 8; ++i)
  {
    vec4 ball = brickBalls[i];
    if (ball.w >= 0.0)
    {
      parts |= partsWithin(e, slot, ball.xyz, ball.w, brickReach[i]);
    }
  }
  return parts;
}

void include(int site, ivec2 low, ivec2 high)
{
  atomicMin(reaches[4 * site], low.x);
  atomicMin(reaches[4 * site + 1], low.y);
  atomicMax(reaches[4 * site + 2], high.x);
  atomicMax(reaches[4 * site + 3], high.y);
}

void main()
{
  uint me = gl_LocalInvocationIndex;
  if (me == 0u)
  {
    left = 0u;
  }
  Tile tile;
  beginTile(ivec3(gl_WorkGroupID.xy, layer), tile);
  ivec2 low = tile.low.xy - slabMin.xy;
  ivec2 high = tile.high.xy - slabMin.xy;
  for (uint chunk = 0u; chunk < tile.range.y; chunk += 64u)
  {
    testGroups(tile, chunk);
    uint candidates = 8u * groupTotal;
    for (uint i = me; i < candidates; i += 64u)
    {
      int slot = int(8u * groups[i >> 3] + (i & 7u));
      Element e = loadElement(slot);
      bool near = partsWithin(e, slot, tile.box.centre, tile.radius, tile.reach) != 0u;
      uint parts = near ? partsOf(e, slot) : 0u;
      atomicAdd(left, uint(bitCount(parts)));
      for (; parts != 0u; parts &= parts - 1u)
      {
        include(partSites[8 * slot + findLSB(parts)], low, high);
      }
    }
    barrier();
    if (me == 0u)
    {
      groupTotal = 0u;
    }
    barrier();
  }
  if (me == 0u)
  {
    atomicAdd(pairs, left);
  }
}
