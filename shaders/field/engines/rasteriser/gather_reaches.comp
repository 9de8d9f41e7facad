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
#include "../device/reach.glsl"
#include "../device/near_elements.glsl"
#include "../device/counters.glsl"
layout(std430, binding = 2) readonly buffer Ranges { uvec2 ranges[]; };
layout(std430, binding = 3) readonly buffer Lists { uint lists[]; };
layout(std430, binding = 5) readonly buffer PartSites { int partSites[]; };
layout(std430, binding = 6) buffer Reaches { int reaches[]; };

uniform ivec3 tiles; // along x, y, z
uniform int tilesAt; // their first range
uniform int layer;

shared uint groups[64]; // that can hold closest points of the tile
shared uint groupTotal;
shared vec4 brickBalls[8]; // around the bricks of 4 x 4 x 4 grid points; w: radius, negative if there is none
shared float brickReach[8];
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
      Place place = placeAt(e, ball.xyz);
      parts |= place.squared <= brickReach[i] ? partsNear(e, slot, place, ball.w + slack) : 0u;
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
  ivec3 tile = ivec3(gl_WorkGroupID.xy, layer);
  ivec3 low = slabMin + 8 * tile;
  ivec3 high = min(low + 7, slabMax);
  Box box = hullOf(low, high);
  uvec2 range = ranges[tilesAt + (tile.z * tiles.y + tile.y) * tiles.x + tile.x];
  beginSearch();
  for (uint item = me; item < range.y; item += 64u)
  {
    int node = int(lists[range.x + item]);
    tryNode(box, loadDisc(node).surfacePoint, node);
  }
  if (me < 8u)
  {
    ivec3 brickLow = low + 4 * ivec3(me & 1u, me >> 1 & 1u, me >> 2);
    Box brick = hullOf(brickLow, min(brickLow + 3, high));
    brickBalls[me] = vec4(brick.centre, any(greaterThan(brickLow, high)) ? -1.0 : length(brick.halfSize));
  }
  if (me == 0u)
  {
    groupTotal = 0u;
    left = 0u;
  }
  endSearch();
  searchElements(box);
  setCornerLimits(box);
  float radius = length(box.halfSize);
  float reach = squaredReach(box.centre, radius);
  if (me < 8u)
  {
    brickReach[me] = squaredReach(brickBalls[me].xyz, brickBalls[me].w);
  }
  barrier();
  for (uint chunk = 0u; chunk < range.y; chunk += 64u)
  {
    if (chunk + me < range.y)
    {
      uint node = lists[range.x + chunk + me];
      if (meets(loadDisc(int(node)), box, radius, reach))
      {
        groups[atomicAdd(groupTotal, 1u)] = node;
      }
    }
    barrier();
    uint candidates = 8u * groupTotal;
    for (uint i = me; i < candidates; i += 64u)
    {
      int slot = int(8u * groups[i >> 3] + (i & 7u));
      Element e = loadElement(slot);
      Place place = placeAt(e, box.centre);
      bool near = place.squared <= reach && partsNear(e, slot, place, radius + slack) != 0u;
      uint parts = near ? partsOf(e, slot) : 0u;
      atomicAdd(left, uint(bitCount(parts)));
      for (; parts != 0u; parts &= parts - 1u)
      {
        include(partSites[8 * slot + findLSB(parts)], low.xy - slabMin.xy, high.xy - slabMin.xy);
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
