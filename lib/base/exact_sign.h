#pragma once

#include <glm/glm.hpp>

#include <cmath>

// Exact signs of determinants of points (Shewchuk 1997). Double precision with a bound of its error
// decides nearly all of them; sums of several doubles decide the rest. Coordinates must be 0 or
// from 1e-70 to 1e100 in magnitude: beyond that, products of three could underflow or overflow.
namespace medial
{

namespace exact
{

/// As orientation(), without the attempt in double precision.
int orientation(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c, const glm::dvec3& d);
int orientation(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c);

/// Returns the determinant of (a - d, b - d, c - d), rounded after it has been computed exactly: it
/// is off by a few units in the last place, and has the right sign.
double determinant(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c,
  const glm::dvec3& d);

} // namespace exact

/// Returns a position that exact signs can be had for: products of three smaller coordinates would
/// be lost.
inline glm::dvec3 withoutTinyCoordinates(const glm::dvec3& x)
{
  constexpr double kMin = 1e-70;
  const auto kept = [](double coordinate)
  { return std::abs(coordinate) < kMin ? 0.0 : coordinate; };
  return { kept(x.x), kept(x.y), kept(x.z) };
}

/// The bounds count the roundings that a product of differences goes through, eight in space and
/// four in the plane, and leave one or more for the bound itself. Fused operations only save some.
constexpr double kHalfUlp = 0x1p-53;
constexpr double kSpaceBound = 10.0 * kHalfUlp;
constexpr double kPlaneBound = 5.0 * kHalfUlp;

/// Returns the sign of a value whose error has a bound, and 0 where it could be another. Without a
/// branch, since processors cannot predict which sign it is.
inline int certainSign(double value, double bound)
{
  return static_cast<int>(value > bound) - static_cast<int>(value < -bound);
}

/// As glm::abs(), which branches.
inline glm::dvec3 magnitudes(const glm::dvec3& v)
{
  return { std::abs(v.x), std::abs(v.y), std::abs(v.z) };
}

/// The plane through three points, kept for the sides of several others. If the points are
/// collinear, all others lie in it.
class SidesOfPlane
{
public:
  SidesOfPlane(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c)
    : a_(a)
    , b_(b)
    , c_(c)
  {
    const glm::dvec3 u = b - a;
    const glm::dvec3 v = c - a;
    const glm::dvec3 first(u.y * v.z, u.z * v.x, u.x * v.y);
    const glm::dvec3 second(u.z * v.y, u.x * v.z, u.y * v.x);
    normal_ = first - second;
    bound_ = kSpaceBound * (magnitudes(first) + magnitudes(second));
  }

  /// Returns the side of d as orientation(a, b, c, d).
  int side(const glm::dvec3& d) const
  {
    const glm::dvec3 offset = d - a_;
    const double height = glm::dot(normal_, offset);
    const double bound = glm::dot(bound_, magnitudes(offset));
    if (const int side = certainSign(-height, bound))
    {
      return side;
    }
    // Without a bound every product is 0.
    return bound == 0.0 ? 0 : exact::orientation(a_, b_, c_, d);
  }

private:
  glm::dvec3 a_;
  glm::dvec3 b_;
  glm::dvec3 c_;
  glm::dvec3 normal_;
  glm::dvec3 bound_; ///< of the error of the normal and of what is computed from it
};

/// Returns the exact sign of the determinant of (a - d, b - d, c - d): -1 if d lies before the
/// plane of a, b, c, on the side that cross(b - a, c - a) points to and from which they appear
/// counterclockwise; 1 if it lies behind; 0 if the four lie in a plane. A swap of two points
/// changes the sign.
inline int orientation(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c,
  const glm::dvec3& d)
{
  return SidesOfPlane(a, b, c).side(d);
}

/// Returns the exact sign of the determinant of (a - c, b - c): 1 if a, b, c are in
/// counterclockwise order, -1 if clockwise, 0 if collinear. A swap of two points changes the sign.
inline int orientation(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c)
{
  const glm::dvec2 u = a - c;
  const glm::dvec2 v = b - c;
  const double first = u.x * v.y;
  const double second = u.y * v.x;
  const double determinant = first - second;
  const double bound = kPlaneBound * (std::abs(first) + std::abs(second));
  if (const int sign = certainSign(determinant, bound))
  {
    return sign;
  }
  return bound == 0.0 ? 0 : exact::orientation(a, b, c);
}

} // namespace medial
