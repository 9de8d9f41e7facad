#pragma once

#include <glm/glm.hpp>

#include <array>

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

} // namespace medial
