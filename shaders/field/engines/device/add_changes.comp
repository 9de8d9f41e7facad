#version 450 core
// Adds changes of the winding number that the host has found to those of cut_rows.comp.
//
// in   found    place and change
// out  changes  as cut_rows.comp has them
#include "numbering.glsl"

layout(local_size_x = 64) in;
layout(std430, binding = 0) readonly buffer Found { ivec2 found[]; };
layout(std430, binding = 1) buffer Changes { int changes[]; };

uniform int count;

void main()
{
  int i = int(itemNumber());
  if (i < count)
  {
    atomicAdd(changes[found[i].x], found[i].y);
  }
}
