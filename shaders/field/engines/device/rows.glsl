// The rows of a slab, with those of the slice below it, and the marks of their grid points: four times as many
// words as hold a bit for every point, for the grid edges along x, y and z and for whether the point is inside.

uniform ivec3 slabSize; // grid points
uniform int slots;      // slices, with the one below the slab

int wordsOfRow()
{
  return (slabSize.x + 31) / 32;
}

const int kInside = 3; // after the axes

int firstWord(int row, int axis)
{
  return (4 * row + axis) * wordsOfRow();
}
