#pragma once

#include "base/simd.h"

#include <glm/glm.hpp>

#include <array>
#include <cmath>

namespace medial
{

/// Returns the solid angle of a triangle over 4 pi, in [-0.5, 0.5]; positive where the corners run
/// clockwise, as from inside a surface that faces outwards (van Oosterom, Strackee 1983).
double solidAngle(const std::array<glm::dvec3, 3>& corners, const glm::dvec3& from);

/// Sums of solid angles at eight points at once. Angles are added as products of complex numbers,
/// with full turns counted, so that there is one arc tangent a sum and not a triangle.
class SolidAngleSums
{
public:
  static constexpr int kPoints = 8;
  using Points = std::array<glm::dvec3, kPoints>;

  explicit SolidAngleSums(const Points& points);

  /// Adds a triangle's solid angle.
  /// @param weight how often it counts.
  void add(const std::array<glm::dvec3, 3>& corners, int weight);

  /// Returns a sum over 4 pi.
  double at(int point) const;

  /// One value for each point.
  using Values = std::array<double, kPoints>;
  /// The points, and the sums as complex numbers and turns.
  struct State
  {
    std::array<Values, 3> points;
    Values real;
    Values imaginary;
    Values turns;
  };

private:
  State state_;
  int unscaled_ = 0; ///< triangles since the numbers were scaled
};

/// A vector without a constructor, which keeps loops over lanes simple for the compiler.
struct Offset
{
  double x;
  double y;
  double z;
};

/// Multiplies a sum of angles, a complex number and full turns, by a complex number.
MEDIAL_INLINE void multiply(double real, double imaginary, double& sumReal, double& sumImaginary,
  double& turns)
{
  const double before = sumImaginary;
  const double newReal = sumReal * real - before * imaginary;
  const double after = sumReal * imaginary + before * real;
  const double forwards = ((imaginary > 0.0) & (before >= 0.0) & (after < 0.0)) ? 1.0 : 0.0;
  const double backwards = ((imaginary < 0.0) & (before < 0.0) & (after >= 0.0)) ? 1.0 : 0.0;
  turns += forwards - backwards;
  sumReal = newReal;
  sumImaginary = after;
}

/// Turns a sum of angles by a triangle's solid angle.
/// @param a, b, c the triangle's corners as seen from the point.
/// @param sense 1, -1 to turn the triangle round, 0 to leave it out.
MEDIAL_INLINE void turnBy(const Offset& a, const Offset& b, const Offset& c, double sense,
  double& sumReal, double& sumImaginary, double& turns)
{
  const double la = std::sqrt(a.x * a.x + a.y * a.y + a.z * a.z);
  const double lb = std::sqrt(b.x * b.x + b.y * b.y + b.z * b.z);
  const double lc = std::sqrt(c.x * c.x + c.y * c.y + c.z * c.z);
  const double volume =
    a.x * (b.y * c.z - b.z * c.y) + a.y * (b.z * c.x - b.x * c.z) + a.z * (b.x * c.y - b.y * c.x);
  const double cosines = la * lb * lc + (a.x * b.x + a.y * b.y + a.z * b.z) * lc +
    (b.x * c.x + b.y * c.y + b.z * c.z) * la + (c.x * a.x + c.y * a.y + c.z * a.z) * lb;
  const double imaginary = sense * volume;
  // In the plane of the triangle the angle is taken as none.
  const double real = imaginary == 0.0 ? 1.0 : cosines;
  multiply(real, imaginary, sumReal, sumImaginary, turns);
}

} // namespace medial
