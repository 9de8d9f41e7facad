#version 450 core
// Lists some of the rectangles of a layer of tiles, by ascending site: where sites are equally near, the one that is
// drawn first stays.
//
// in   firsts      number of rectangles before those of every site
// out  rectangles  by sevens: site, first grid point, last grid point
#include "../device/numbering.glsl"
#include "site_rectangles.glsl"

layout(local_size_x = 64) in;
layout(std430, binding = 1) readonly buffer Firsts { uint firsts[]; };
layout(std430, binding = 2) writeonly buffer Rectangles { int rectangles[]; };

uniform int siteCount;
uniform ivec3 slabMin;
uniform ivec2 slices; // first and last of the layer
uniform int begin;    // those in [begin, end) are listed
uniform int end;

void store(int at, int site, ivec2 low, ivec2 high)
{
  int values[7] = int[7](site, slabMin.x + low.x, slabMin.y + low.y, slices.x, slabMin.x + high.x,
    slabMin.y + high.y, slices.y);
  for (int i = 0; i < 7; ++i)
  {
    rectangles[7 * at + i] = values[i];
  }
}

void main()
{
  int site = int(itemNumber());
  if (site >= siteCount || reaches[site].z < reaches[site].x)
  {
    return;
  }
  ivec4 reach = reaches[site];
  ivec2 parts = partsOf(reach);
  int number = int(firsts[site]);
  for (int i = 0; i < parts.x * parts.y; ++i, ++number)
  {
    if (number >= begin && number < end)
    {
      ivec2 low = reach.xy + kLongest * ivec2(i % parts.x, i / parts.x);
      store(number - begin, site, low, min(low + kLongest - 1, reach.zw));
    }
  }
}
