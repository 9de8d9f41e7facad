#pragma once

#include "medial/triangle_mesh.h"
#include "support/transforms.h"

#include <array>

// Solids whose sheets have known borders. Lengths are world units, angles degrees.
namespace medial::test
{

/// An ellipsoid with half axes 1, 0.8 and 0.45, whose axis is part of an ellipse in z = 0.
struct Ellipsoid
{
  static constexpr double kC = 0.45;
  static constexpr double kA2 = 1.0 - kC * kC; ///< squared half axes of the whole axis
  static constexpr double kB2 = 0.64 - kC * kC;

  static TriangleMesh mesh(int subdivisions);

  /// Half axes of the part with a separation angle of at least `angle`. There the radius r = c
  /// sqrt(1 - x^2 / kA2 - y^2 / kB2) grows by at most cos(angle / 2).
  static std::array<double, 2> border(double angle);

  /// Distance of a point from the border, to first order.
  static double offBorder(const Point3& p, const std::array<double, 2>& half);
};

/// All points within `radius` of a rectangle |x| <= halfLength, |y| <= halfWidth in z = 0, which is
/// its axis.
TriangleMesh roundedPlate(double halfLength, double halfWidth, double radius, int subdivisions);

/// Area of the axis of a box with half axes a >= b >= c.
double boxAxisArea(double a, double b, double c);

} // namespace medial::test
