// The groups that are left for a tile of 8 x 8 x 8 grid points, tested by a work group of 64, and the eight bricks of
// 4 x 4 x 4 grid points in the tile. Needs elements.glsl.
#include "reach.glsl"
#include "near_elements.glsl"

layout(std430, binding = 2) readonly buffer Ranges { uvec2 ranges[]; };
layout(std430, binding = 3) readonly buffer Lists { uint lists[]; };

uniform ivec3 tiles; // along x, y, z
uniform int tilesAt; // their first range

struct Tile
{
  ivec3 low, high; // its first and last grid points
  Box box;
  uvec2 range;  // of its list
  float radius; // of the ball around it
  float reach;  // squared distance from its centre within which closest points lie
};

shared uint groups[64]; // that can hold closest points of the tile
shared uint groupTotal;
shared vec4 brickBalls[8]; // around the bricks; w: radius, negative if there is none
shared float brickReach[8];

// Bounds the reach of a tile by surface points near its corners: of the groups whose surface points are nearest to
// them.
void beginTile(ivec3 at, out Tile tile)
{
  uint me = gl_LocalInvocationIndex;
  tile.low = slabMin + 8 * at;
  tile.high = min(tile.low + 7, slabMax);
  tile.box = hullOf(tile.low, tile.high);
  tile.range = ranges[tilesAt + (at.z * tiles.y + at.y) * tiles.x + at.x];
  beginSearch();
  for (uint item = me; item < tile.range.y; item += 64u)
  {
    int node = int(lists[tile.range.x + item]);
    tryNode(tile.box, loadDisc(node).surfacePoint, node);
  }
  if (me < 8u)
  {
    ivec3 low = tile.low + 4 * ivec3(me & 1u, me >> 1 & 1u, me >> 2);
    Box brick = hullOf(low, min(low + 3, tile.high));
    brickBalls[me] = vec4(brick.centre, any(greaterThan(low, tile.high)) ? -1.0 : length(brick.halfSize));
  }
  if (me == 0u)
  {
    groupTotal = 0u;
  }
  endSearch();
  searchElements(tile.box);
  setCornerLimits(tile.box);
  tile.radius = length(tile.box.halfSize);
  tile.reach = squaredReach(tile.box.centre, tile.radius);
  if (me < 8u)
  {
    brickReach[me] = squaredReach(brickBalls[me].xyz, brickBalls[me].w);
  }
  barrier();
}

// Moves those of 64 groups of the list that can hold closest points of the tile to groups[].
void testGroups(Tile tile, uint chunk)
{
  uint item = chunk + gl_LocalInvocationIndex;
  if (item < tile.range.y)
  {
    uint node = lists[tile.range.x + item];
    if (meets(loadDisc(int(node)), tile.box, tile.radius, tile.reach))
    {
      groups[atomicAdd(groupTotal, 1u)] = node;
    }
  }
  barrier();
}

// The parts of an element that can hold closest points of a ball, as bits.
uint partsWithin(Element e, int slot, vec3 centre, float radius, float reach)
{
  Place place = placeAt(e, centre);
  return place.squared <= reach ? partsNear(e, slot, place, radius + slack) : 0u;
}
