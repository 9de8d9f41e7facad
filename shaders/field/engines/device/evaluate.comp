#version 450 core
// Finds the element nearest to every grid point of a brick of 4 x 4 x 4, one by each invocation, among the groups
// that are left for its tile of 8 x 8 x 8. Of elements at the same distance it is the one with the lowest site.
//
// in   elements, discs, ranges, lists  of the tiles
// out  winners  slot of the nearest element of every grid point; -1 if there is none

layout(local_size_x = 64) in;
#include "elements.glsl"
#include "reach.glsl"
#include "near_elements.glsl"
#include "counters.glsl"
layout(std430, binding = 2) readonly buffer Ranges { uvec2 ranges[]; };
layout(std430, binding = 3) readonly buffer Lists { uint lists[]; };
layout(std430, binding = 5) writeonly buffer Winners { int winners[]; };

uniform dvec3 exactFirst; // grid point (0,0,0)
uniform dvec3 exactSpacing;
uniform ivec3 tiles; // along x, y, z
uniform int tilesAt; // their first range
uniform int layer;   // the first of the bricks along z

shared uint groups[64]; // that can hold closest points of the brick
shared uint groupTotal;
shared uint survivors[512]; // slots of elements that are left
shared uint cubes[512];     // for which cubes of the brick each of them is, as bits
shared uint survivorTotal;
shared vec4 cubeBalls[8]; // around the cubes of 2 x 2 x 2 grid points; w: radius, negative if there is none
shared float cubeReach[8];
shared uint evaluated;
shared uint left;
shared uint missing;

// For which cubes an element can hold closest points, as bits.
uint cubesOf(Element e, int slot)
{
  uint found = 0u;
  for (int i = 0; i < 8; ++i)
  {
    vec4 ball = cubeBalls[i];
    if (ball.w >= 0.0)
    {
      Place place = placeAt(e, ball.xyz);
      found |= place.squared <= cubeReach[i] && partsNear(e, slot, place, ball.w + slack) != 0u ? 1u << i : 0u;
    }
  }
  return found;
}

void main()
{
  uint me = gl_LocalInvocationIndex;
  ivec3 brick = ivec3(gl_WorkGroupID) + ivec3(0, 0, layer);
  ivec3 low = slabMin + 4 * brick;
  ivec3 high = min(low + 3, slabMax);
  Box box = hullOf(low, high);
  ivec3 tile = brick / 2;
  uvec2 range = ranges[tilesAt + (tile.z * tiles.y + tile.y) * tiles.x + tile.x];

  // Surface points near the corners: of the groups whose surface points are nearest to them.
  beginSearch();
  for (uint item = me; item < range.y; item += 64u)
  {
    int node = int(lists[range.x + item]);
    tryNode(box, loadDisc(node).surfacePoint, node);
  }
  if (me < 8u)
  {
    ivec3 cubeLow = low + 2 * ivec3(me & 1u, me >> 1 & 1u, me >> 2);
    Box cube = hullOf(cubeLow, min(cubeLow + 1, high));
    cubeBalls[me] = vec4(cube.centre, any(greaterThan(cubeLow, high)) ? -1.0 : length(cube.halfSize));
  }
  if (me == 0u)
  {
    evaluated = 0u;
    left = 0u;
    missing = 0u;
    groupTotal = 0u;
    survivorTotal = 0u;
  }
  endSearch();
  searchElements(box);
  setCornerLimits(box);
  float radius = length(box.halfSize);
  float reach = squaredReach(box.centre, radius);
  if (me < 8u)
  {
    cubeReach[me] = squaredReach(cubeBalls[me].xyz, cubeBalls[me].w);
  }
  barrier();

  int myCube = int(me) >> 3;
  ivec3 point = low + 2 * ivec3(myCube & 1, myCube >> 1 & 1, myCube >> 2) +
    ivec3(me & 1u, me >> 1 & 1u, me >> 2 & 1u);
  bool isMine = all(lessThanEqual(point, high));
  dvec3 exact = exactFirst + dvec3(point) * exactSpacing;
  vec3 x = vec3(exact);
  vec3 xLow = vec3(exact - dvec3(x));
  float best = kFar;
  int winner = -1;
  int winnerSite = 0;
  uint count = 0u;
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
      if (place.squared <= reach && partsNear(e, slot, place, radius + slack) != 0u)
      {
        uint found = cubesOf(e, slot);
        if (found != 0u)
        {
          uint at = atomicAdd(survivorTotal, 1u);
          survivors[at] = uint(slot);
          cubes[at] = found;
        }
      }
    }
    barrier();
    for (uint i = 0u; i < survivorTotal; ++i)
    {
      if (isMine && (cubes[i] >> myCube & 1u) != 0u)
      {
        int slot = int(survivors[i]);
        Element e = loadElement(slot);
        float squared = placeOf(e, inPlane(e, x, xLow)).squared;
        ++count;
        if (squared < best || (squared == best && e.site < winnerSite))
        {
          best = squared;
          winner = slot;
          winnerSite = e.site;
        }
      }
    }
    barrier();
    if (me == 0u)
    {
      left += survivorTotal;
      groupTotal = 0u;
      survivorTotal = 0u;
    }
    barrier();
  }
  atomicAdd(evaluated, count);
  if (isMine)
  {
    winners[pointNumber(point)] = winner;
    if (winner < 0)
    {
      atomicAdd(missing, 1u);
    }
  }
  barrier();
  if (me == 0u)
  {
    atomicAdd(tests, range.y);
    atomicAdd(pairs, left);
    atomicAdd(evaluations, evaluated);
    atomicAdd(withoutSite, missing);
  }
}
