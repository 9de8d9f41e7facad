// The rows of a slab, with those of the slice below it, and bits of their grid points.

uniform ivec3 slabSize; // grid points
uniform int slots;      // slices, with the one below the slab

int wordsOfRow()
{
  return (slabSize.x + 31) / 32;
}
