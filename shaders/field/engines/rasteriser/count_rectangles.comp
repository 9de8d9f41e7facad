#version 450 core
// How many rectangles every site has in a layer of tiles.
//
// out  counts
#include "../device/numbering.glsl"
#include "site_rectangles.glsl"

layout(local_size_x = 64) in;
layout(std430, binding = 1) writeonly buffer Counts { uint counts[]; };

uniform int siteCount;

void main()
{
  int site = int(itemNumber());
  if (site < siteCount)
  {
    ivec4 reach = reaches[site];
    ivec2 parts = reach.z >= reach.x ? partsOf(reach) : ivec2(0);
    counts[site] = uint(parts.x * parts.y);
  }
}
