#pragma once

#include <glm/glm.hpp>

#include <cmath>

namespace medial
{

/// Angle, in radians, between the directions from x to two surface points.
inline double separationAngle(const glm::dvec3& x, const glm::dvec3& a, const glm::dvec3& b)
{
  const glm::dvec3 u = a - x;
  const glm::dvec3 v = b - x;
  return std::atan2(glm::length(glm::cross(u, v)), glm::dot(u, v));
}

} // namespace medial
