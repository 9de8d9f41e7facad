// Reads the elements that elements.comp makes; eight in a row are a group.
#include "element.glsl"

layout(std430, binding = 0) readonly buffer Elements { uvec4 elements[]; };

const int kRows = 7; // of a record, that describe an element; the others bound Voronoi regions

Element elementOf(uvec4 r[kRows])
{
  Element e;
  e.origin = uintBitsToFloat(r[0].xyz);
  e.flags = r[0].w;
  e.along = uintBitsToFloat(r[1].xyz);
  e.across = uintBitsToFloat(r[2].xyz);
  e.originLow = uintBitsToFloat(r[3].xyz);
  e.starts = uintBitsToFloat(uvec3(r[1].w, r[2].w, r[3].w));
  e.directions = uintBitsToFloat(r[4]);
  e.ends = uintBitsToFloat(r[5].xyz);
  e.site = int(r[5].w);
  e.offsets = uintBitsToFloat(r[6].xyz);
  return e;
}

Element loadElement(int slot)
{
  uvec4 rows[kRows];
  for (int i = 0; i < kRows; ++i)
  {
    rows[i] = elements[kRecord * slot + i];
  }
  return elementOf(rows);
}

// Returns the owned parts whose Voronoi regions meet a ball: as partsNear().
uint partsNear(Element e, int slot, Place centre, float radius)
{
  vec3 foldCosine = uintBitsToFloat(elements[kRecord * slot + 7].xyz);
  vec3 foldSine = uintBitsToFloat(elements[kRecord * slot + 8].xyz);
  vec3 intoNeighbour = foldCosine * centre.outside + foldSine * centre.height;
  vec3 past = max(centre.before, centre.beyond);
  bool withoutFace = (e.flags & kHasFace) == 0u;
  uint parts = centre.offFace <= radius ? 1u : 0u;
  for (int edge = 0; edge < 3; ++edge)
  {
    bool near = (withoutFace || centre.outside[edge] >= -radius) && intoNeighbour[edge] <= radius &&
      past[edge] <= radius;
    parts |= near ? 2u << edge : 0u;
  }
  parts |= centre.before.x >= -radius && centre.before.z >= -radius ? 16u : 0u;
  parts |= centre.beyond.x >= -radius && centre.before.y >= -radius ? 32u : 0u;
  parts |= centre.beyond.y >= -radius && centre.beyond.z >= -radius ? 64u : 0u;
  return (parts | e.flags >> kUnboundedShift) & e.flags & kOwned;
}
