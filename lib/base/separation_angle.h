#pragma once

#include "medial/error.h"

#include <glm/glm.hpp>

#include <cmath>
#include <string>

namespace medial
{

/// Returns the angle, in radians, between the directions from x to two surface points.
inline double separationAngle(const glm::dvec3& x, const glm::dvec3& a, const glm::dvec3& b)
{
  const glm::dvec3 u = a - x;
  const glm::dvec3 v = b - x;
  return std::atan2(glm::length(glm::cross(u, v)), glm::dot(u, v));
}

/// Checks a minimum separation angle.
/// @throws Error InvalidInput if it is outside (0, 180) degrees.
inline void checkSeparationAngle(double angle)
{
  if (!(angle > 0.0 && angle < 180.0))
  {
    throw Error(ErrorCode::InvalidInput,
      "separation angle " + std::to_string(angle) + " is outside (0, 180) degrees");
  }
}

} // namespace medial
