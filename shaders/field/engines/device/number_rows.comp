#version 450 core
// Where the crossings of every row begin in the list of all. One work group does it.
//
// in, out  rowCounts  number of crossings, then number of those before the row
// out      crossings  number of all
#include "counters.glsl"
#include "rows.glsl"

layout(local_size_x = 256) in;
layout(std430, binding = 0) buffer RowCounts { uint rowCounts[]; };

shared uint sums[256];

void main()
{
  uint me = gl_LocalInvocationIndex;
  uint rows = uint(slots * slabSize.y);
  uint share = (rows + 255u) / 256u;
  uint begin = min(me * share, rows);
  uint end = min(begin + share, rows);
  uint sum = 0u;
  for (uint row = begin; row < end; ++row)
  {
    sum += rowCounts[row];
  }
  sums[me] = sum;
  barrier();
  uint before = 0u;
  for (uint i = 0u; i < me; ++i)
  {
    before += sums[i];
  }
  if (me == 255u)
  {
    crossings = before + sum;
  }
  for (uint row = begin; row < end; ++row)
  {
    uint count = rowCounts[row];
    rowCounts[row] = before;
    before += count;
  }
}
