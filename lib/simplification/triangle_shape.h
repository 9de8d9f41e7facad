#pragma once

#include <glm/glm.hpp>

#include <algorithm>
#include <array>

namespace medial
{

using TrianglePoints = std::array<glm::dvec3, 3>;

/// Returns the normal with a length of twice the area.
inline glm::dvec3 areaVector(const TrianglePoints& p)
{
  return glm::cross(p[1] - p[0], p[2] - p[0]);
}

/// Returns twice the area, divided by the squared length of the longest edge.
inline double heightRatio(const TrianglePoints& p)
{
  const auto squared = [](const glm::dvec3& d) { return glm::dot(d, d); };
  const double edge2 =
    std::max({ squared(p[1] - p[0]), squared(p[2] - p[1]), squared(p[0] - p[2]) });
  return edge2 > 0.0 ? glm::length(areaVector(p)) / edge2 : 0.0;
}

/// Whether a triangle still has area after a move.
inline bool keepsArea(const TrianglePoints& after)
{
  return heightRatio(after) > 1e-5;
}

/// Whether it also neither turns over nor becomes much more slender.
inline bool keepsShape(const TrianglePoints& before, const TrianglePoints& after)
{
  constexpr double kMinCosine = 0.2;
  constexpr double kSlender = 2e-3;
  const glm::dvec3 from = areaVector(before);
  const glm::dvec3 to = areaVector(after);
  return keepsArea(after) && heightRatio(after) > std::min(kSlender, heightRatio(before)) &&
    glm::dot(from, to) >= kMinCosine * glm::length(from) * glm::length(to);
}

} // namespace medial
