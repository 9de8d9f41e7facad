#pragma once

#include "medial/grid.h"

#include <glm/glm.hpp>

#include <array>

namespace medial
{

inline glm::dvec3 toVector(const Point3& point)
{
  return { point[0], point[1], point[2] };
}

inline Point3 toPoint(const glm::dvec3& vector)
{
  return { vector.x, vector.y, vector.z };
}

/// Returns two unit vectors normal to a unit vector and to each other.
inline std::array<glm::dvec3, 2> normalsTo(const glm::dvec3& direction)
{
  const glm::dvec3 size = glm::abs(direction);
  const glm::dvec3 other = size.x <= size.y && size.x <= size.z
    ? glm::dvec3(1.0, 0.0, 0.0)
    : (size.y <= size.z ? glm::dvec3(0.0, 1.0, 0.0) : glm::dvec3(0.0, 0.0, 1.0));
  const glm::dvec3 u = glm::normalize(glm::cross(direction, other));
  return { u, glm::cross(direction, u) };
}

} // namespace medial
