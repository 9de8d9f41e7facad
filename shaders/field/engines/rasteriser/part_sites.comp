#version 450 core
// The sites of the parts of every element.
//
// in   order  the site of every element; -1 where there is none
// out  sites  by eights: of the face, the edges AB, BC, AC and the corners A, B, C; -1 where there is none
#include "../device/numbering.glsl"
#include "../device/mesh.glsl"
#include "../device/faces.glsl"

layout(local_size_x = 64) in;
layout(std430, binding = 3) readonly buffer Order { int order[]; };
layout(std430, binding = 4) writeonly buffer Sites { int sites[]; };

uniform int slotCount;

void main()
{
  int slot = int(itemNumber());
  if (slot >= slotCount)
  {
    return;
  }
  int site = order[slot];
  int parts[8] = int[8](-1, -1, -1, -1, -1, -1, -1, -1);
  if (site >= 0 && site < faceCount)
  {
    int longest = longestEdge(site);
    ivec3 edges = faceEdges(site);
    ivec3 corners = faceCorners(site);
    parts[0] = site;
    for (int i = 0; i < 3; ++i)
    {
      parts[1 + i] = faceCount + edges[(longest + i) % 3];
      parts[4 + i] = firstVertex() + corners[(longest + i) % 3];
    }
  }
  else if (site >= 0 && site < firstVertex())
  {
    ivec2 ends = edgeEnds(site - faceCount);
    parts[1] = site;
    parts[4] = firstVertex() + ends.x;
    parts[5] = firstVertex() + ends.y;
  }
  else if (site >= 0)
  {
    parts[4] = site;
  }
  for (int i = 0; i < 8; ++i)
  {
    sites[8 * slot + i] = parts[i];
  }
}
