#version 450 core
// Which grid points are inside: those where the changes from the beginning of the row on sum up to a winding number of
// 1 or more. One invocation does a row.
//
// in   changes  of the winding number, from one grid point of a row to the next
// out  bits     of grid points, 1 for those inside
#include "numbering.glsl"
#include "rows.glsl"

layout(local_size_x = 64) in;
layout(std430, binding = 0) readonly buffer Changes { int changes[]; };
layout(std430, binding = 1) writeonly buffer Bits { uint bits[]; };

void main()
{
  int row = int(itemNumber());
  if (row >= slots * slabSize.y)
  {
    return;
  }
  int winding = 0;
  for (int word = 0; word < wordsOfRow(); ++word)
  {
    uint found = 0u;
    int end = min(slabSize.x - 32 * word, 32);
    for (int i = 0; i < end; ++i)
    {
      winding += changes[row * slabSize.x + 32 * word + i];
      found |= winding >= 1 ? 1u << i : 0u;
    }
    bits[row * wordsOfRow() + word] = found;
  }
}
