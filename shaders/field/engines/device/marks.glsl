// The marks of grid points: four times as many words as hold a bit for every point, for the grid edges along x, y
// and z and for whether the point is inside. Needs rows.glsl.

const int kInside = 3; // after the axes

int firstWord(int row, int axis)
{
  return (4 * row + axis) * wordsOfRow();
}
