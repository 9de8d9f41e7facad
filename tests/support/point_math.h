#pragma once

#include "medial/grid.h"

#include <cmath>
#include <cstddef>
#include <vector>

// Arithmetic of points and vectors, apart from the library's own.
namespace medial::test
{

constexpr double kPi = 3.14159265358979323846; // a constant even before other files are initialised

inline double degrees(double radians)
{
  return radians * 180.0 / kPi;
}

inline double dot(const Point3& a, const Point3& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

inline Point3 cross(const Point3& a, const Point3& b)
{
  return { a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0] };
}

inline Point3 minus(const Point3& a, const Point3& b)
{
  return { a[0] - b[0], a[1] - b[1], a[2] - b[2] };
}

inline double length(const Point3& a)
{
  return std::sqrt(dot(a, a));
}

inline double distance(const Point3& a, const Point3& b)
{
  return length(minus(a, b));
}

/// Radians.
inline double angleBetween(const Point3& a, const Point3& b)
{
  return std::atan2(length(cross(a, b)), dot(a, b));
}

/// Sum of the angles between consecutive parts of a line, degrees.
inline double turning(const std::vector<Point3>& line)
{
  double sum = 0.0;
  for (std::size_t i = 2; i < line.size(); ++i)
  {
    sum += angleBetween(minus(line[i - 1], line[i - 2]), minus(line[i], line[i - 1]));
  }
  return degrees(sum);
}

} // namespace medial::test
