#version 450 core
// Finds out which nodes of the tree can hold the closest points of a box of grid points, from the list of the
// box of twice the size. One work group does one box.
//
// in   discs   of all nodes
// out  ranges  where the lists of boxes are: x: start, y: length
//      lists   nodes, numbered within their level of the tree

layout(local_size_x = 64) in;
#include "reach.glsl"
#include "counters.glsl"
layout(std430, binding = 2) buffer Ranges { uvec2 ranges[]; };
layout(std430, binding = 3) buffer Lists { uint lists[]; };

uniform int boxSize;        // grid points along an edge
uniform ivec3 parents;      // number of boxes of twice the size along x, y, z
uniform int parentsAt;      // their first range; -1 where the list is all nodes
uniform int boxesAt;        // first range of these boxes
uniform bool descend;       // whether the parents' nodes are of the level above
uniform int firstNode;      // first disc of the level
uniform int nodeCount;      // nodes of the level
uniform int room;           // for all lists

const uint kBits = 8192u;
shared uint passed[256]; // the first kBits of them
shared uint total;
shared uint begin;
shared uint stored;

uvec2 range = uvec2(0u);

// Returns the node of an item of the list, or -1.
int nodeOf(uint item)
{
  uint at = descend ? item >> 3 : item;
  uint node = parentsAt < 0 ? at : lists[range.x + at];
  node = descend ? 8u * node + (item & 7u) : node;
  return node < uint(nodeCount) ? int(node) : -1;
}

void main()
{
  ivec3 at = ivec3(gl_WorkGroupID);
  ivec3 low = slabMin + boxSize * at;
  Box box = hullOf(low, min(low + boxSize - 1, slabMax));
  ivec3 parent = at / 2;
  range = parentsAt < 0 ? uvec2(0u, uint(nodeCount))
                        : ranges[parentsAt + (parent.z * parents.y + parent.y) * parents.x + parent.x];
  uint items = descend && parentsAt >= 0 ? 8u * range.y : range.y;
  uint me = gl_LocalInvocationIndex;
  beginSearch();
  for (uint item = me; item < items; item += 64u)
  {
    int node = nodeOf(item);
    if (node >= 0)
    {
      tryNode(box, loadDisc(firstNode + node).surfacePoint, node);
    }
  }
  for (uint i = me; i < 256u; i += 64u)
  {
    passed[i] = 0u;
  }
  if (me == 0u)
  {
    total = 0u;
    stored = 0u;
  }
  endSearch();
  if (me < 9u)
  {
    nearPoints[me] = loadDisc(firstNode + nearestNodes[me]).surfacePoint;
  }
  barrier();
  setCornerLimits(box);
  float radius = length(box.halfSize);
  float reach = squaredReach(box.centre, radius);
  for (uint item = me; item < items; item += 64u)
  {
    int node = nodeOf(item);
    if (node >= 0 && item >= kBits)
    {
      atomicAdd(total, 1u); // room for all of them, since a second test need not be rounded as the first
    }
    else if (node >= 0 && meets(loadDisc(firstNode + node), box, radius, reach))
    {
      atomicAdd(total, 1u);
      atomicOr(passed[item >> 5], 1u << (item & 31u));
    }
  }
  barrier();
  if (me == 0u)
  {
    begin = atomicAdd(listLength, total);
    atomicAdd(tests, items);
  }
  barrier();
  bool fits = total <= uint(room) && begin <= uint(room) - total;
  for (uint item = me; fits && item < items; item += 64u)
  {
    bool isLeft = item < kBits ? (passed[item >> 5] >> (item & 31u) & 1u) != 0u : false;
    int node = nodeOf(item);
    if (item >= kBits)
    {
      isLeft = node >= 0 && meets(loadDisc(firstNode + node), box, radius, reach);
    }
    if (isLeft)
    {
      lists[begin + atomicAdd(stored, 1u)] = uint(node);
    }
  }
  barrier();
  if (me == 0u)
  {
    ivec3 boxes = ivec3(gl_NumWorkGroups);
    ranges[boxesAt + (at.z * boxes.y + at.y) * boxes.x + at.x] = uvec2(begin, stored);
  }
}
