#pragma once

#include "base/simd.h"
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

/// Triangles whose height is a smaller part of their longest edge are taken for their edges: their
/// normal is lost in rounding, and the edges are as near.
constexpr double kMinHeight = 1e-10;

/// Returns the point of the edges of an element closest to a position.
glm::dvec3 closestOnEdges(const Element& element, const glm::dvec3& x);

/// Returns the point of an element closest to a position, by the signs of the barycentric
/// coordinates (Ericson, Real-Time Collision Detection, 2004, 5.1.5).
MEDIAL_INLINE glm::dvec3 closestPoint(const Element& element, const glm::dvec3& x)
{
  const auto& [a, b, c] = element.corners;
  const glm::dvec3 ab = b - a;
  const glm::dvec3 ac = c - a;
  const double abA = glm::dot(ab, x - a);
  const double acA = glm::dot(ac, x - a);
  if (abA <= 0.0 && acA <= 0.0)
  {
    return a;
  }
  const double abB = glm::dot(ab, x - b);
  const double acB = glm::dot(ac, x - b);
  if (abB >= 0.0 && acB <= abB)
  {
    return b;
  }
  const double abC = glm::dot(ab, x - c);
  const double acC = glm::dot(ac, x - c);
  if (acC >= 0.0 && abC <= acC)
  {
    return c;
  }
  const double ofC = abA * acB - abB * acA;
  if (ofC <= 0.0 && abA >= 0.0 && abB <= 0.0 && abA > abB)
  {
    return a + abA / (abA - abB) * ab;
  }
  const double ofB = abC * acA - abA * acC;
  if (ofB <= 0.0 && acA >= 0.0 && acC <= 0.0 && acA > acC)
  {
    return a + acA / (acA - acC) * ac;
  }
  const double ofA = abB * acC - abC * acB;
  const double toC = acB - abB;
  const double toB = abC - acC;
  if (ofA <= 0.0 && toC >= 0.0 && toB >= 0.0 && toC + toB > 0.0)
  {
    return b + toC / (toC + toB) * (c - b);
  }
  const double sum = ofA + ofB + ofC;
  constexpr double kSliver = kMinHeight * kMinHeight;
  if (sum <= kSliver * glm::dot(ab, ab) * glm::dot(ac, ac))
  {
    return closestOnEdges(element, x);
  }
  return a + ofB / sum * ab + ofC / sum * ac;
}

/// Whether an element is no farther than that from a position.
inline bool isNear(const Element& element, const glm::dvec3& x, double distance)
{
  return glm::distance(closestPoint(element, x), x) <= distance;
}

/// Returns the edge of a triangle from a corner to the next one.
inline Element edgeOf(const Element& triangle, int corner)
{
  const glm::dvec3& end = triangle.corners[(corner + 1) % 3];
  return { { triangle.corners[corner], end, end } };
}

} // namespace medial
