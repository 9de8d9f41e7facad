#version 450 core
// Lists the marked grid edges by row, axis and x. One invocation does a row.
//
// in   sites, marks, rowCounts
// out  list  x: x + y 2^16; y: z + axis 2^16, and 2^31 if it is inside; z, w: sites at both ends
#include "numbering.glsl"
#include "rows.glsl"
#include "marks.glsl"

layout(local_size_x = 64) in;
layout(std430, binding = 0) readonly buffer Sites { int sites[]; };
layout(std430, binding = 1) readonly buffer Marks { uint marks[]; };
layout(std430, binding = 2) readonly buffer RowCounts { uint rowCounts[]; };
layout(std430, binding = 3) writeonly buffer List { uvec4 list[]; };

uniform ivec3 slabMin;
uniform int room; // of the list

void main()
{
  int row = int(itemNumber());
  if (row >= slots * slabSize.y)
  {
    return;
  }
  uint next = rowCounts[row];
  int slot = row / slabSize.y;
  ivec3 strides = ivec3(1, slabSize.x, slabSize.x * slabSize.y);
  for (int axis = 0; axis < 3; ++axis)
  {
    for (int word = 0; word < wordsOfRow(); ++word)
    {
      for (uint left = marks[firstWord(row, axis) + word]; left != 0u; left &= left - 1u)
      {
        int x = 32 * word + findLSB(left);
        int i = row * slabSize.x + x;
        if (next < uint(room))
        {
          uvec3 point = uvec3(slabMin + ivec3(x, row - slot * slabSize.y, slot - 1));
          uint inside = marks[firstWord(row, kInside) + word] >> (x & 31) & 1u;
          list[next] = uvec4(point.x | point.y << 16, point.z | uint(axis) << 16 | inside << 31,
            uint(sites[i]), uint(sites[i + strides[axis]]));
        }
        ++next;
      }
    }
  }
}
