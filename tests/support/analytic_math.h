#pragma once

#include "medial/grid.h"

#include <algorithm>
#include <cmath>

// What the files of analytic axes share.
namespace medial::test
{

inline const double kPi = std::acos(-1.0);

inline double degrees(double radians)
{
  return radians * 180.0 / kPi;
}

inline double dot(const Point3& a, const Point3& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

inline Point3 minus(const Point3& a, const Point3& b)
{
  return { a[0] - b[0], a[1] - b[1], a[2] - b[2] };
}

inline double length(const Point3& a)
{
  return std::sqrt(dot(a, a));
}

/// Facets of a round shape of radius 1 per spacing: the sag is some hundredths of it.
inline int segments(double spacing)
{
  return 4 * static_cast<int>(std::ceil(4.0 / std::sqrt(spacing)));
}

inline int subdivisions(double spacing)
{
  return spacing > 0.06 ? 4 : 5;
}

inline Bounds around(const Point3& half)
{
  Bounds bounds;
  bounds.min = { -half[0], -half[1], -half[2] };
  bounds.max = half;
  return bounds;
}

} // namespace medial::test
