// The mesh: its points, and who shares them with whom. Sites are numbered as in SiteSet: faces, then edges, then
// vertices.

layout(std430, binding = 0) readonly buffer Connectivity { int connectivity[]; };
layout(std430, binding = 1) readonly buffer Points { double points[]; }; // local coordinates, by threes

uniform int faceCount;
uniform int edgeCount;
uniform int vertexCount;
uniform int incidenceCount; // pairs of an edge and one of its faces

int firstVertex()
{
  return faceCount + edgeCount;
}

dvec3 pointAt(int vertex)
{
  return dvec3(points[3 * vertex], points[3 * vertex + 1], points[3 * vertex + 2]);
}

ivec3 faceCorners(int face)
{
  return ivec3(connectivity[3 * face], connectivity[3 * face + 1], connectivity[3 * face + 2]);
}

// edge i joins the corners i and i + 1
ivec3 faceEdges(int face)
{
  int at = 3 * (faceCount + face);
  return ivec3(connectivity[at], connectivity[at + 1], connectivity[at + 2]);
}

ivec2 edgeEnds(int edge)
{
  int at = 6 * faceCount + 2 * edge;
  return ivec2(connectivity[at], connectivity[at + 1]);
}

// where the faces of an edge begin, and where they end
ivec2 edgeFaceRange(int edge)
{
  int at = 6 * faceCount + 2 * edgeCount + edge;
  return ivec2(connectivity[at], connectivity[at + 1]) + 6 * faceCount + 3 * edgeCount + 1;
}

// where the edges of a vertex begin, and where they end
ivec2 vertexEdgeRange(int vertex)
{
  int at = 6 * faceCount + 3 * edgeCount + 1 + incidenceCount;
  return ivec2(connectivity[at + vertex], connectivity[at + vertex + 1]) + at + vertexCount + 1;
}
