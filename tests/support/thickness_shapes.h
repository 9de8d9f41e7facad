#pragma once

#include "medial/triangle_mesh.h"

#include <array>
#include <vector>

// Solids whose walls are known. Lengths are world units.
namespace medial::test
{

/// What lies between cylinders of radii inner < outer about the z axis, |z| <= height / 2, with n
/// sides and 16 rings of triangles along each wall.
TriangleMesh tube(double inner, double outer, double height, int n);

/// Prism over |z| <= halfHeight of a convex polygon, whose corners run counterclockwise.
TriangleMesh prism(const std::vector<std::array<double, 2>>& corners, double halfHeight);

} // namespace medial::test
