#pragma once

#include "base/range_check.h"

#include <glm/glm.hpp>

#include <cmath>

namespace medial
{

/// Returns the angle, in radians, between the directions from x to two surface points.
inline double separationAngle(const glm::dvec3& x, const glm::dvec3& a, const glm::dvec3& b)
{
  const glm::dvec3 u = a - x;
  const glm::dvec3 v = b - x;
  return std::atan2(glm::length(glm::cross(u, v)), glm::dot(u, v));
}

/// A separation angle to compare others with.
class AngleLimit
{
public:
  /// @param angle radians.
  explicit AngleLimit(double angle)
    : angle_(angle)
    , cosine_(std::cos(angle))
  {
  }

  /// Whether separationAngle(x, a, b) is as large. It is as if the angle were computed, but this is
  /// hardly ever necessary.
  bool isReached(const glm::dvec3& x, const glm::dvec3& a, const glm::dvec3& b) const
  {
    const glm::dvec3 u = a - x;
    const glm::dvec3 v = b - x;
    const double lengths = std::sqrt(glm::dot(u, u) * glm::dot(v, v));
    const double over = glm::dot(u, v) - cosine_ * lengths;
    constexpr double kDoubt = 1e-9; // of the cosine
    return std::abs(over) > kDoubt * lengths ? over < 0.0 : separationAngle(x, a, b) >= angle_;
  }

private:
  double angle_;
  double cosine_;
};

/// Checks a minimum separation angle.
/// @throws Error InvalidInput if it is outside (0, 180) degrees.
inline void checkSeparationAngle(double angle)
{
  if (!(angle > 0.0 && angle < 180.0))
  {
    throwOutside("separation angle", angle, "(0, 180) degrees");
  }
}

} // namespace medial
