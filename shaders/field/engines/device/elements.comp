#version 450 core
// Describes every element in its plane, with the neighbours at its edges: as makeSiteGroup().
//
// in   order     the site of every element, eight of them a group; -1 where there is none
// out  elements  see element.glsl
#include "numbering.glsl"
#include "axes.glsl"
#include "mesh.glsl"
#include "faces.glsl"
#include "element.glsl"

layout(local_size_x = 64) in;
layout(std430, binding = 3) readonly buffer Edges { ivec4 edges[]; };
layout(std430, binding = 4) readonly buffer Vertices { ivec2 vertices[]; };
layout(std430, binding = 5) readonly buffer Order { int order[]; };
layout(std430, binding = 6) writeonly buffer Elements { uvec4 elements[]; };

uniform int slotCount;

dvec3 unitOr(dvec3 v, dvec3 otherwise)
{
  double size = length(v);
  return size > 0.0LF ? v / size : otherwise;
}

dvec2 unitOr(dvec2 v, dvec2 otherwise)
{
  double size = length(v);
  return size > 0.0LF ? v / size : otherwise;
}

dvec3 orthogonal(dvec3 u)
{
  dvec3 size = abs(u);
  int axis = size.x <= size.y ? (size.x <= size.z ? 0 : 2) : (size.y <= size.z ? 1 : 2);
  return normalize(cross(u, unitVector(axis)));
}

// Returns the unit vector orthogonal to an edge that points into one of its faces.
dvec3 intoFace(int face, int edge)
{
  ivec2 ends = edgeEnds(edge);
  dvec3 p = pointAt(ends.x);
  dvec3 u = unitOr(pointAt(ends.y) - p, dvec3(1.0LF, 0.0LF, 0.0LF));
  ivec3 corners = faceCorners(face);
  dvec3 into = dvec3(0.0LF);
  for (int i = 0; i < 3; ++i)
  {
    dvec3 v = pointAt(corners[i]) - p;
    into += v - dot(v, u) * u;
  }
  return unitOr(into, dvec3(0.0LF));
}

// Returns the point of the segment p-q nearest to x, in the plane.
dvec2 onSegment(dvec2 p, dvec2 q, dvec2 x)
{
  dvec2 along = q - p;
  double squared = dot(along, along);
  double t = squared > 0.0LF ? clamp(dot(x - p, along) / squared, 0.0LF, 1.0LF) : 0.0LF;
  return p + t * along;
}

// Returns the point of the triangle A, b, c nearest to x, in the plane; A is the origin, b on the x axis.
dvec2 nearestPoint(dvec2 b, dvec2 c, dvec2 x, bool hasFace)
{
  dvec2 bc = c - b;
  bool inside = hasFace && x.y > 0.0LF && bc.x * (x.y - b.y) - bc.y * (x.x - b.x) > 0.0LF &&
    c.x * x.y - c.y * x.x < 0.0LF;
  if (inside)
  {
    return x;
  }
  dvec2 best = onSegment(dvec2(0.0LF), b, x);
  dvec2 others[2] = dvec2[2](onSegment(b, c, x), onSegment(dvec2(0.0LF), c, x));
  for (int i = 0; i < 2; ++i)
  {
    best = distance(others[i], x) < distance(best, x) ? others[i] : best;
  }
  return best;
}

void store(int slot, int row, vec3 v, uint w)
{
  elements[kRecord * slot + row] = uvec4(floatBitsToUint(v), w);
}

void main()
{
  int slot = int(itemNumber());
  if (slot >= slotCount)
  {
    return;
  }
  int site = order[slot];
  if (site < 0)
  {
    for (int row = 0; row < kRecord; ++row)
    {
      store(slot, row, vec3(0.0), 0u);
    }
    return;
  }
  bool isFace = site < faceCount;
  bool isEdge = !isFace && site < firstVertex();
  bool hasFace = false;
  ivec3 border = ivec3(-1);
  ivec3 corners;
  dvec3 up = dvec3(0.0LF);
  if (isFace)
  {
    int longest = longestEdge(site);
    ivec3 itsEdges = faceEdges(site);
    ivec3 itsCorners = faceCorners(site);
    for (int i = 0; i < 3; ++i)
    {
      border[i] = itsEdges[(longest + i) % 3];
      corners[i] = itsCorners[(longest + i) % 3];
    }
    up = faceNormal(site);
    hasFace = faceActive(site);
  }
  else if (isEdge)
  {
    border.x = site - faceCount;
    corners = edgeEnds(border.x).xyx;
  }
  else
  {
    corners = ivec3(site - firstVertex());
  }
  dvec3 a = pointAt(corners.x);
  dvec3 b = pointAt(corners.y);
  dvec3 c = pointAt(corners.z);

  dvec3 along = unitOr(b - a, dvec3(1.0LF, 0.0LF, 0.0LF));
  // Orthogonal to the edge to the last bit, which the normal of a needle need not be.
  up -= dot(up, along) * along;
  dvec3 normal = length(up) > 0.5LF ? normalize(up) : orthogonal(along);
  dvec3 across = cross(normal, along);
  dvec2 flatB = dvec2(distance(a, b), 0.0LF);
  dvec2 flatC = dvec2(dot(c - a, along), dot(c - a, across));
  dvec2 origin = nearestPoint(flatB, flatC, dvec2(-dot(a, along), -dot(a, across)), hasFace);
  dvec3 origin3 = a + origin.x * along + origin.y * across;
  dvec2 fromB = unitOr(flatC - flatB, dvec2(1.0LF, 0.0LF));
  dvec2 fromA = unitOr(flatC, dvec2(1.0LF, 0.0LF));
  dvec2 originFromB = origin - flatB;
  dvec3 starts = -dvec3(origin.x, dot(originFromB, fromB), dot(origin, fromA));
  dvec3 ends = starts + dvec3(flatB.x, distance(b, c), distance(a, c));
  dvec3 offsets = dvec3(-origin.y, originFromB.x * fromB.y - originFromB.y * fromB.x,
    origin.y * fromA.x - origin.x * fromA.y);

  uint owned = hasFace ? 1u : 0u;
  dvec2 outwards[3] = dvec2[3](dvec2(0.0LF, -1.0LF), dvec2(fromB.y, -fromB.x), dvec2(-fromA.y, fromA.x));
  vec3 foldCosine = vec3(0.0);
  vec3 foldSine = vec3(0.0);
  for (int i = 0; i < 3; ++i)
  {
    ivec4 edge = border[i] >= 0 ? edges[border[i]] : ivec4(-1);
    if (border[i] >= 0 && edge.z == site && (edge.w & 1) != 0)
    {
      owned |= 2u << i;
      int neighbour = edge.x == site ? edge.y : edge.x;
      dvec3 into = neighbour >= 0 ? intoFace(neighbour, border[i]) : dvec3(0.0LF);
      foldCosine[i] = float(dot(into, outwards[i].x * along + outwards[i].y * across));
      foldSine[i] = float(dot(into, normal));
    }
    bool repeated = (i > 0 && corners[i] == corners.x) || (i > 1 && corners[i] == corners.y);
    owned |= !repeated && vertices[corners[i]].x == site ? 16u << i : 0u;
  }
  // Without length, an edge has no direction that bounds anything.
  bool bounded = a != b && b != c && (isEdge || a != c);
  uint flags = owned | (bounded ? 0u : owned << kUnboundedShift) | (hasFace ? kHasFace : 0u) | kExists;

  vec3 high = vec3(origin3);
  vec3 first = vec3(starts);
  store(slot, 0, high, flags);
  store(slot, 1, vec3(along), floatBitsToUint(first.x));
  store(slot, 2, vec3(across), floatBitsToUint(first.y));
  store(slot, 3, vec3(origin3 - dvec3(high)), floatBitsToUint(first.z));
  vec4 directions = vec4(dvec4(fromB, fromA));
  store(slot, 4, directions.xyz, floatBitsToUint(directions.w));
  store(slot, 5, vec3(ends), uint(site));
  store(slot, 6, vec3(offsets), 0u);
  store(slot, 7, foldCosine, 0u);
  store(slot, 8, foldSine, 0u);
}
