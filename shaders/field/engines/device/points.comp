#version 450 core
// Unpacks the points of a mesh.
//
// in   positions  fixed-point numbers, or both halves of double-precision ones
// out  points     local coordinates
#include "numbering.glsl"
#include "axes.glsl"

layout(local_size_x = 64) in;
layout(std430, binding = 0) readonly buffer Positions { uint positions[]; };
layout(std430, binding = 1) writeonly buffer Points { double points[]; };

uniform int count;       // coordinates
uniform bool fixedPoint; // positions are low + quantum * number
uniform dvec3 low;
uniform double quantum;

void main()
{
  uint i = itemNumber();
  if (i < uint(count))
  {
    points[i] = fixedPoint ? coordinate(low, int(i % 3u)) + quantum * double(positions[i])
                           : packDouble2x32(uvec2(positions[2u * i], positions[2u * i + 1u]));
  }
}
