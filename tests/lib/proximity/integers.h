#pragma once

#include <glm/glm.hpp>

#include <array>
#include <cmath>

// Exact arithmetic for tests: integers of 128 bits, and doubles as multiples of a power of two.
namespace medial::test
{

__extension__ using Integer = __int128;

using IntegerVector = std::array<Integer, 3>;

inline int signOf(Integer value)
{
  return value > 0 ? 1 : value < 0 ? -1 : 0;
}

inline IntegerVector difference(const IntegerVector& a, const IntegerVector& b)
{
  return { a[0] - b[0], a[1] - b[1], a[2] - b[2] };
}

inline Integer dot(const IntegerVector& a, const IntegerVector& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

inline IntegerVector cross(const IntegerVector& a, const IntegerVector& b)
{
  return { a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0] };
}

/// Returns the coordinates as multiples of 2^exponent, which they must be, below 2^63 of them.
inline IntegerVector multiples(const glm::dvec3& point, int exponent)
{
  const auto multiple = [&](double coordinate)
  { return static_cast<Integer>(std::llround(std::ldexp(coordinate, -exponent))); };
  return { multiple(point.x), multiple(point.y), multiple(point.z) };
}

/// The side of d of the plane through a, b and c, as medial::orientation() has it.
inline int exactSide(const IntegerVector& a, const IntegerVector& b, const IntegerVector& c,
  const IntegerVector& d)
{
  return signOf(dot(difference(a, d), cross(difference(b, d), difference(c, d))));
}

} // namespace medial::test
