#version 450 core
// Which elements own the vertices, and where the surface goes on all around: as SharedSites.
//
// in   edges     of edges.comp
// out  vertices  x: the site of the owner; y: whether the surface ends or branches there, or turns its other
//                side out
#include "numbering.glsl"
#include "mesh.glsl"

layout(local_size_x = 64) in;
layout(std430, binding = 3) readonly buffer Edges { ivec4 edges[]; };
layout(std430, binding = 4) writeonly buffer Vertices { ivec2 vertices[]; };

void main()
{
  int vertex = int(itemNumber());
  if (vertex >= vertexCount)
  {
    return;
  }
  ivec2 found = ivec2(firstVertex() + vertex, 0);
  ivec2 range = vertexEdgeRange(vertex);
  for (int i = range.x; i < range.y; ++i)
  {
    ivec4 edge = edges[connectivity[i]];
    found.x = min(found.x, edge.z);
    found.y |= (edge.w & 2) == 0 ? 1 : 0;
  }
  vertices[vertex] = found;
}
