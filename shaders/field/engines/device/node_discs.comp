#version 450 core
// The discs around eight discs of the level below: as discOf() in GroupTree.
#include "numbering.glsl"
#include "disc.glsl"

layout(local_size_x = 64) in;
layout(std430, binding = 1) buffer Discs { vec4 discs[]; };

uniform int below;      // first disc of the level below
uniform int belowCount; // and their number
uniform int first;      // first disc of this level
uniform float slack;    // bound of the rounding of single precision

void main()
{
  int node = int(itemNumber());
  int begin = below + 8 * node;
  int end = min(begin + 8, below + belowCount);
  if (begin >= end)
  {
    return;
  }
  dvec3 area = dvec3(0.0LF);
  for (int i = begin; i < end; ++i)
  {
    double radius = double(discs[kDisc * i].w);
    area += dvec3(discs[kDisc * i + 1].xyz) * (radius * radius);
  }
  double size = length(area);
  dvec3 n = size > 0.0LF ? area / size : dvec3(0.0LF, 0.0LF, 1.0LF);
  double lowest = 0.0LF;
  double highest = 0.0LF;
  dvec3 low = dvec3(0.0LF);
  dvec3 high = dvec3(0.0LF);
  float cone = 0.0;
  for (int i = begin; i < end; ++i)
  {
    dvec4 flat0 = dvec4(discs[kDisc * i]);
    dvec4 flat1 = dvec4(discs[kDisc * i + 1]);
    double cosine = dot(n, flat1.xyz);
    double across = min(abs(cosine), 1.0LF);
    double sine = sqrt(1.0LF - across * across);
    double reach = flat0.w * sine + flat1.w * across;
    double height = dot(n, flat0.xyz);
    double wide = flat0.w + flat1.w * sine;
    bool any = i > begin;
    lowest = any ? min(lowest, height - reach) : height - reach;
    highest = any ? max(highest, height + reach) : height + reach;
    low = any ? min(low, flat0.xyz - wide) : flat0.xyz - wide;
    high = any ? max(high, flat0.xyz + wide) : flat0.xyz + wide;
    float slope = discs[kDisc * i + 2].w;
    cone = max(cone, slope < kNoCone ? atan(slope) + angleOf(cosine) : kNoCone);
  }
  dvec3 middle = 0.5LF * (low + high);
  dvec3 centre = middle + (0.5LF * (lowest + highest) - dot(n, middle)) * n;
  double radius = 0.0LF;
  double nearest = -1.0LF;
  vec3 surfacePoint = vec3(centre);
  for (int i = begin; i < end; ++i)
  {
    dvec4 flat0 = dvec4(discs[kDisc * i]);
    dvec4 flat1 = dvec4(discs[kDisc * i + 1]);
    double across = min(abs(dot(n, flat1.xyz)), 1.0LF);
    dvec3 v = flat0.xyz - centre;
    radius = max(radius, length(v - dot(v, n) * n) + flat0.w + flat1.w * sqrt(1.0LF - across * across));
    vec3 point = discs[kDisc * i + 2].xyz;
    double away = distance(dvec3(point), centre);
    if (nearest < 0.0LF || away < nearest)
    {
      nearest = away;
      surfacePoint = point;
    }
  }
  // The discs below have the slack already; this is for rounding once more.
  float rounding = 0.25 * slack;
  discs[kDisc * (first + node)] = vec4(vec3(centre), float(radius) + rounding);
  discs[kDisc * (first + node) + 1] = vec4(vec3(n), float(0.5LF * (highest - lowest)) + rounding);
  discs[kDisc * (first + node) + 2] = vec4(surfacePoint, slopeOf(cone));
}
