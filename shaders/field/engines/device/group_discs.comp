#version 450 core
// The discs around groups of eight elements, each by eight invocations: as discOf() in GroupTree.
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

// What the elements of a group have in common; one of its eight invocations knows each.
shared dvec3 areas[64];
shared dvec3 lows[64], highs[64]; // of their corners
shared dvec2 heights[64];         // lowest and highest along the axis
shared double cosines[64];
shared double radii[64];
shared double nears[64]; // distances of their middles from the centre; negative if there is no element

// Twice the area of a face, along its normal.
dvec3 areaOf(int site)
{
  if (site < 0 || site >= faceCount)
  {
    return dvec3(0.0LF);
  }
  ivec3 corners = faceCorners(site);
  dvec3 a = pointAt(corners.x);
  return cross(pointAt(corners.y) - a, pointAt(corners.z) - a);
}

void main()
{
  uint me = gl_LocalInvocationIndex;
  uint begin = me & ~7u;
  int group = int(itemNumber() >> 3);
  int site = group < groupCount ? order[8 * group + int(me & 7u)] : -1;
  areas[me] = areaOf(site);
  barrier();
  dvec3 area = dvec3(0.0LF);
  for (uint i = begin; i < begin + 8u; ++i)
  {
    area += areas[i];
  }
  double size = length(area);
  dvec3 n = size > 0.0LF ? area / size : dvec3(0.0LF, 0.0LF, 1.0LF);
  dvec3 corners[3];
  if (site >= 0)
  {
    ivec3 ids = cornersOf(site);
    corners = dvec3[3](pointAt(ids.x), pointAt(ids.y), pointAt(ids.z));
    dvec3 along = dvec3(dot(n, corners[0]), dot(n, corners[1]), dot(n, corners[2]));
    heights[me] = dvec2(min(along.x, min(along.y, along.z)), max(along.x, max(along.y, along.z)));
    lows[me] = min(corners[0], min(corners[1], corners[2]));
    highs[me] = max(corners[0], max(corners[1], corners[2]));
    cosines[me] = minCosine(site, n);
  }
  nears[me] = site >= 0 ? 0.0LF : -1.0LF;
  barrier();
  // An element that is there comes first, since the order has no gaps within a group.
  dvec2 height = heights[begin];
  dvec3 low = lows[begin];
  dvec3 high = highs[begin];
  double cosine = cosines[begin];
  for (uint i = begin + 1u; i < begin + 8u; ++i)
  {
    if (nears[i] >= 0.0LF)
    {
      height = dvec2(min(height.x, heights[i].x), max(height.y, heights[i].y));
      low = min(low, lows[i]);
      high = max(high, highs[i]);
      cosine = min(cosine, cosines[i]);
    }
  }
  dvec3 middle = 0.5LF * (low + high);
  dvec3 centre = middle + (0.5LF * (height.x + height.y) - dot(n, middle)) * n;
  barrier();
  if (site >= 0)
  {
    double radius = 0.0LF;
    for (int k = 0; k < 3; ++k)
    {
      dvec3 v = corners[k] - centre;
      radius = max(radius, length(v - dot(v, n) * n));
    }
    radii[me] = radius;
    lows[me] = middleOf(site);
    nears[me] = distance(lows[me], centre);
  }
  barrier();
  if (group < groupCount && me == begin)
  {
    double radius = 0.0LF;
    uint nearest = begin;
    for (uint i = begin; i < begin + 8u; ++i)
    {
      if (nears[i] >= 0.0LF)
      {
        radius = max(radius, radii[i]);
        nearest = nears[i] < nears[nearest] ? i : nearest;
      }
    }
    discs[kDisc * group] = vec4(vec3(centre), float(radius) + slack);
    discs[kDisc * group + 1] = vec4(vec3(n), float(0.5LF * (height.y - height.x)) + slack);
    discs[kDisc * group + 2] = vec4(vec3(lows[nearest]), cosine > 0.0LF ? slopeOf(angleOf(cosine)) : kNoCone);
  }
}
