#pragma once

#include <glm/glm.hpp>

#include <limits>

namespace medial
{

/// An axis-aligned box, world units.
struct Box
{
  glm::dvec3 min{ std::numeric_limits<double>::infinity() };
  glm::dvec3 max{ -std::numeric_limits<double>::infinity() };

  void add(const glm::dvec3& point)
  {
    min = glm::min(min, point);
    max = glm::max(max, point);
  }
  void add(const Box& other)
  {
    min = glm::min(min, other.min);
    max = glm::max(max, other.max);
  }

  glm::dvec3 size() const { return max - min; }
  bool overlaps(const Box& other) const
  {
    return glm::all(glm::lessThanEqual(min, other.max)) &&
      glm::all(glm::lessThanEqual(other.min, max));
  }
  bool contains(const glm::dvec3& point) const
  {
    return glm::all(glm::lessThanEqual(min, point)) && glm::all(glm::lessThanEqual(point, max));
  }
  double squaredDistance(const Box& other) const
  {
    const glm::dvec3 gap = glm::max(glm::max(other.min - max, min - other.max), glm::dvec3(0.0));
    return glm::dot(gap, gap);
  }
  double squaredDistance(const glm::dvec3& point) const
  {
    const glm::dvec3 gap = glm::max(glm::max(min - point, point - max), glm::dvec3(0.0));
    return glm::dot(gap, gap);
  }
};

} // namespace medial
