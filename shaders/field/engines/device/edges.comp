#version 450 core
// Which edges are sites, which elements own them, and which faces meet there: as SiteSet and SharedSites.
//
// out  edges  x, y: the first two faces that are sites, or -1; z: the site of the owner; w: kActive, kClosed
#include "numbering.glsl"
#include "mesh.glsl"
#include "faces.glsl"

const int kActive = 1;
const int kClosed = 2; // two faces meet there, and run through the edge in different directions

layout(local_size_x = 64) in;
layout(std430, binding = 3) writeonly buffer Edges { ivec4 edges[]; };

double edgeLength(int edge)
{
  ivec2 ends = edgeEnds(edge);
  return distance(pointAt(ends.x), pointAt(ends.y));
}

// The edge for which the others of a face without area stand: the longest, of equal ones the last.
int coveredEdge(int face)
{
  ivec3 border = faceEdges(face);
  int covered = border.x;
  double coveredLength = edgeLength(border.x);
  for (int i = 1; i < 3; ++i)
  {
    double size = edgeLength(border[i]);
    if (size > coveredLength || (size == coveredLength && border[i] > covered))
    {
      covered = border[i];
      coveredLength = size;
    }
  }
  return covered;
}

bool runsAlong(int face, int edge)
{
  ivec3 border = faceEdges(face);
  int corner = border.x == edge ? 0 : (border.y == edge ? 1 : 2);
  return faceCorners(face)[corner] == edgeEnds(edge).x;
}

void main()
{
  int edge = int(itemNumber());
  if (edge >= edgeCount)
  {
    return;
  }
  ivec4 found = ivec4(-1, -1, faceCount + edge, edgeLength(edge) > 0.0LF ? kActive : 0);
  int sites = 0;
  int direction = 0;
  ivec2 range = edgeFaceRange(edge);
  for (int i = range.x; i < range.y; ++i)
  {
    int face = connectivity[i];
    found.z = min(found.z, face);
    if (faceNormal(face) == dvec3(0.0LF) && coveredEdge(face) == edge)
    {
      found.w = 0;
    }
    if (faceActive(face))
    {
      if (sites < 2)
      {
        found[sites] = face;
      }
      ++sites;
      direction += runsAlong(face, edge) ? 1 : -1;
    }
  }
  found.w |= sites == 2 && direction == 0 ? kClosed : 0;
  edges[edge] = found;
}
