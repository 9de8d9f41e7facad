#version 450 core
// The discs around groups of eight elements: as discOf() in GroupTree.
//
// out  discs  see disc.glsl
#include "numbering.glsl"
#include "mesh.glsl"
#include "faces.glsl"
#include "disc.glsl"

layout(local_size_x = 64) in;
layout(std430, binding = 3) readonly buffer Edges { ivec4 edges[]; };
layout(std430, binding = 4) readonly buffer Vertices { ivec2 vertices[]; };
layout(std430, binding = 5) readonly buffer Order { int order[]; };
layout(std430, binding = 6) writeonly buffer Discs { vec4 discs[]; };

uniform int groupCount;
uniform float slack; // bound of the rounding of single precision

ivec3 cornersOf(int site)
{
  if (site < faceCount)
  {
    return faceCorners(site);
  }
  return site < firstVertex() ? edgeEnds(site - faceCount).xyx : ivec3(site - firstVertex());
}

dvec3 middleOf(int site)
{
  ivec3 corners = cornersOf(site);
  if (site >= faceCount)
  {
    return 0.5LF * (pointAt(corners.x) + pointAt(corners.y));
  }
  return (pointAt(corners.x) + pointAt(corners.y) + pointAt(corners.z)) / 3.0LF;
}

// Returns the smallest cosine between an axis and the normals of the faces at an element's sites; -1 where there
// is no cone.
double minCosine(int site, dvec3 axis)
{
  if (site >= faceCount || !faceActive(site))
  {
    return -1.0LF;
  }
  double least = 1.0LF;
  ivec3 corners = faceCorners(site);
  for (int i = 0; i < 3; ++i)
  {
    if (vertices[corners[i]].y != 0)
    {
      return -1.0LF;
    }
    ivec2 range = vertexEdgeRange(corners[i]);
    for (int k = range.x; k < range.y; ++k)
    {
      ivec2 pair = edges[connectivity[k]].xy;
      least = min(least, min(dot(axis, faceNormal(pair.x)), dot(axis, faceNormal(pair.y))));
    }
  }
  return least;
}

void main()
{
  int group = int(itemNumber());
  if (group >= groupCount)
  {
    return;
  }
  dvec3 area = dvec3(0.0LF);
  for (int i = 0; i < 8; ++i)
  {
    int site = order[8 * group + i];
    if (site >= 0 && site < faceCount)
    {
      ivec3 corners = faceCorners(site);
      dvec3 a = pointAt(corners.x);
      area += cross(pointAt(corners.y) - a, pointAt(corners.z) - a);
    }
  }
  double size = length(area);
  dvec3 n = size > 0.0LF ? area / size : dvec3(0.0LF, 0.0LF, 1.0LF);
  double lowest = 0.0LF;
  double highest = 0.0LF;
  dvec3 low = dvec3(0.0LF);
  dvec3 high = dvec3(0.0LF);
  double cosine = 1.0LF;
  bool any = false;
  for (int i = 0; i < 8; ++i)
  {
    int site = order[8 * group + i];
    if (site < 0)
    {
      continue;
    }
    ivec3 corners = cornersOf(site);
    for (int k = 0; k < 3; ++k)
    {
      dvec3 p = pointAt(corners[k]);
      double height = dot(n, p);
      lowest = any ? min(lowest, height) : height;
      highest = any ? max(highest, height) : height;
      low = any ? min(low, p) : p;
      high = any ? max(high, p) : p;
      any = true;
    }
    cosine = min(cosine, minCosine(site, n));
  }
  dvec3 middle = 0.5LF * (low + high);
  dvec3 centre = middle + (0.5LF * (lowest + highest) - dot(n, middle)) * n;
  double radius = 0.0LF;
  dvec3 surfacePoint = centre;
  double nearest = -1.0LF;
  for (int i = 0; i < 8; ++i)
  {
    int site = order[8 * group + i];
    if (site < 0)
    {
      continue;
    }
    ivec3 corners = cornersOf(site);
    for (int k = 0; k < 3; ++k)
    {
      dvec3 v = pointAt(corners[k]) - centre;
      radius = max(radius, length(v - dot(v, n) * n));
    }
    dvec3 point = middleOf(site);
    double away = distance(point, centre);
    if (nearest < 0.0LF || away < nearest)
    {
      nearest = away;
      surfacePoint = point;
    }
  }
  discs[kDisc * group] = vec4(vec3(centre), float(radius) + slack);
  discs[kDisc * group + 1] = vec4(vec3(n), float(0.5LF * (highest - lowest)) + slack);
  discs[kDisc * group + 2] = vec4(vec3(surfacePoint), cosine > 0.0LF ? slopeOf(angleOf(cosine)) : kNoCone);
}
