#pragma once

#include <glm/glm.hpp>

#include <algorithm>

namespace medial
{

/// Returns the squared distance of a position from a line segment, whose ends may be the same.
inline double squaredDistanceToSegment(const glm::dvec3& x, const glm::dvec3& a,
  const glm::dvec3& b)
{
  const glm::dvec3 along = b - a;
  const double square = glm::dot(along, along);
  const double t = square > 0.0 ? std::clamp(glm::dot(x - a, along) / square, 0.0, 1.0) : 0.0;
  const glm::dvec3 gap = x - (a + t * along);
  return glm::dot(gap, gap);
}

} // namespace medial
