#version 450 core
// Finds the element nearest to every grid point of a tile of 8 x 8 x 8, among the groups that are left for the tile.
// One work group does a tile, an invocation a block of 2 x 2 x 2 grid points; eight blocks are a brick of 4 x 4 x 4.
// Of elements at the same distance it is the one with the lowest site.
//
// in   elements, discs, ranges, lists  of the tiles
// out  winners  site that names the nearest element of every grid point; -1 if there is none

layout(local_size_x = 64) in;
#include "elements.glsl"
#include "tile_groups.glsl"
#include "counters.glsl"
layout(std430, binding = 5) writeonly buffer Winners { int winners[]; };

uniform dvec3 exactFirst; // grid point (0,0,0)
uniform dvec3 exactSpacing;
uniform int layer;   // the first of the tiles along z

shared uint survivors[512]; // slots of elements that are left
shared uint bricks[512];    // for which bricks each of them is, as bits
shared uint survivorTotal;
shared uint evaluated;
shared uint left;
shared uint missing;

// The best of the elements so far for the grid points of a block.
float best[8];
int winner[8];

// Moves their elements that can hold closest points of the tile to survivors[], and finds out for which bricks.
void testElements(Tile tile)
{
  for (uint i = gl_LocalInvocationIndex; i < 8u * groupTotal; i += 64u)
  {
    int slot = int(8u * groups[i >> 3] + (i & 7u));
    if (partsWithin(loadElement(slot), slot, tile.box.centre, tile.radius, tile.reach) != 0u)
    {
      uint at = atomicAdd(survivorTotal, 1u);
      survivors[at] = uint(slot);
      bricks[at] = 0u;
    }
  }
  barrier();
  for (uint i = gl_LocalInvocationIndex; i < 8u * survivorTotal; i += 64u)
  {
    int slot = int(survivors[i >> 3]);
    uint brick = i & 7u;
    vec4 ball = brickBalls[brick];
    if (ball.w >= 0.0 && partsWithin(loadElement(slot), slot, ball.xyz, ball.w, brickReach[brick]) != 0u)
    {
      atomicOr(bricks[i >> 3], 1u << brick);
    }
  }
  barrier();
}

// at: of the block's first grid point
void tryElement(Element e, Coordinates at, Coordinates steps[3])
{
  for (int k = 0; k < 8; ++k)
  {
    Coordinates c = at;
    if ((k & 1) != 0)
    {
      c = sum(c, steps[0]);
    }
    if ((k & 2) != 0)
    {
      c = sum(c, steps[1]);
    }
    if ((k & 4) != 0)
    {
      c = sum(c, steps[2]);
    }
    float squared = placeOf(e, c).squared;
    if (squared < best[k] || (squared == best[k] && e.site < winner[k]))
    {
      best[k] = squared;
      winner[k] = e.site;
    }
  }
}

void main()
{
  uint me = gl_LocalInvocationIndex;
  if (me == 0u)
  {
    evaluated = 0u;
    left = 0u;
    missing = 0u;
    survivorTotal = 0u;
  }
  Tile tile;
  beginTile(ivec3(gl_WorkGroupID) + ivec3(0, 0, layer), tile);

  int brick = int(me) >> 3;
  ivec3 point = tile.low + 4 * ivec3(brick & 1, brick >> 1 & 1, brick >> 2) +
    2 * ivec3(me & 1u, me >> 1 & 1u, me >> 2 & 1u);
  bool isMine = all(lessThanEqual(point, tile.high));
  dvec3 exact = exactFirst + dvec3(point) * exactSpacing;
  vec3 x = vec3(exact);
  vec3 xLow = vec3(exact - dvec3(x));
  float blockRadius = 0.5 * length(spacing);
  float blockReach = squaredReach(x + 0.5 * spacing, blockRadius); // beyond it elements are nearest to no point
  for (int k = 0; k < 8; ++k)
  {
    best[k] = kFar;
    winner[k] = -1;
  }
  uint count = 0u;
  for (uint chunk = 0u; chunk < tile.range.y; chunk += 64u)
  {
    testGroups(tile, chunk);
    testElements(tile);
    for (uint i = 0u; i < survivorTotal; ++i)
    {
      if (isMine && (bricks[i] >> brick & 1u) != 0u)
      {
        Element e = loadElement(int(survivors[i]));
        Coordinates at = coordinatesOf(e, inPlane(e, x, xLow));
        mat3 axes = axesInPlane(e);
        Coordinates steps[3] = Coordinates[3](growthOf(e, spacing.x * axes[0]), growthOf(e, spacing.y * axes[1]),
          growthOf(e, spacing.z * axes[2]));
        Coordinates middle = sum(at, growthOf(e, 0.5 * (axes * spacing)));
        float squared = placeOf(e, middle).squared;
        if (squared <= blockReach)
        {
          float wide = sqrt(squared) + 2.0 * (blockRadius + slack);
          blockReach = min(blockReach, wide * wide * kRoundedUp);
          tryElement(e, at, steps);
          ++count;
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
  for (int k = 0; k < 8; ++k)
  {
    ivec3 at = point + ivec3(k & 1, k >> 1 & 1, k >> 2);
    if (all(lessThanEqual(at, tile.high)))
    {
      winners[pointNumber(at)] = winner[k];
      if (winner[k] < 0)
      {
        atomicAdd(missing, 1u);
      }
    }
  }
  barrier();
  if (me == 0u)
  {
    atomicAdd(tests, tile.range.y);
    atomicAdd(pairs, left);
    atomicAdd(evaluations, evaluated);
    atomicAdd(withoutSite, missing);
  }
}
