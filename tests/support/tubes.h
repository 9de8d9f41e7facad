#pragma once

#include "medial/triangle_mesh.h"

#include <vector>

namespace medial::test
{

/// A straight tube with rounded ends: what is within a radius of a line.
struct Tube
{
  Point3 from;
  Point3 to;
  double radius;
};

/// The union of tubes. Vertices lie on the surface; the mesh is closed and oriented outwards.
/// @param spacing of the cubes in whose tetrahedra the surface is found.
TriangleMesh unionOf(const std::vector<Tube>& tubes, double spacing);

/// A tube about the z axis, |z| <= height / 2, with `sides` sides and open ends.
TriangleMesh openTube(double radius, double height, int sides);

} // namespace medial::test
