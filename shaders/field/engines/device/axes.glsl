// The axes of double-precision vectors by their numbers. NVIDIA's compiler (580.159.04) does not link programs that
// index such vectors by a variable.

dvec3 unitVector(int axis)
{
  return dvec3(axis == 0 ? 1.0LF : 0.0LF, axis == 1 ? 1.0LF : 0.0LF, axis == 2 ? 1.0LF : 0.0LF);
}

double coordinate(dvec3 v, int axis)
{
  return axis == 0 ? v.x : (axis == 1 ? v.y : v.z);
}
