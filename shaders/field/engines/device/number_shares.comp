#version 450 core
// Where everyone's share begins in a list of all. One work group does it.
//
// in, out  counts  how many are one's own, then how many are before them
// out      listed  number of all
#include "counters.glsl"

layout(local_size_x = 256) in;
layout(std430, binding = 0) buffer Counts { uint counts[]; };

uniform int count;

shared uint sums[256];

void main()
{
  uint me = gl_LocalInvocationIndex;
  uint share = (uint(count) + 255u) / 256u;
  uint begin = min(me * share, uint(count));
  uint end = min(begin + share, uint(count));
  uint sum = 0u;
  for (uint i = begin; i < end; ++i)
  {
    sum += counts[i];
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
    listed = before + sum;
  }
  for (uint i = begin; i < end; ++i)
  {
    uint own = counts[i];
    counts[i] = before;
    before += own;
  }
}
