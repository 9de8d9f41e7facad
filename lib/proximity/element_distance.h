#pragma once

#include "proximity/element_intersection.h"

#include <glm/glm.hpp>

#include <limits>

namespace medial
{

/// Points of two elements, or of an element and a position, that are close to each other.
struct ClosePoints
{
  double squared = std::numeric_limits<double>::infinity(); ///< distance
  glm::dvec3 a{ 0.0 };
  glm::dvec3 b{ 0.0 };
};

/// Returns the closest points of two elements that do not intersect, and the distance to rounding.
ClosePoints closestPoints(const Element& a, const Element& b);

/// Returns the point of an element closest to a position.
glm::dvec3 closestPoint(const Element& element, const glm::dvec3& x);

} // namespace medial
