#pragma once

#include <glm/glm.hpp>

#include <array>

namespace medial
{

/// A closed triangle, or a closed segment or a point where corners are equal. Three collinear
/// corners are the longest segment between them. Coordinates must be in the range of exact_sign.h.
struct Element
{
  std::array<glm::dvec3, 3> corners;

  Element moved(const glm::dvec3& translation) const
  {
    return { { corners[0] + translation, corners[1] + translation, corners[2] + translation } };
  }
};

/// Returns whether two elements share a point, be it a single one. Exact: the same for both orders
/// of the elements and for any order of their corners.
bool intersect(const Element& a, const Element& b);

/// Finds the one point in which a closed segment meets the plane of a triangle, where it lies in
/// the closed triangle; false if there is none or if the whole segment lies in the plane. The
/// answer is exact, and the same for both directions of the segment and any order of the triangle's
/// corners.
/// @param triangle with an area; nothing crosses other elements.
/// @param[out] at set if the answer is true, rounded: off by 1e-8 of the segment's length at most
///   and mostly by a few units in the last place, within the box around the segment, and bit-equal
///   for both directions.
bool crossing(const glm::dvec3& from, const glm::dvec3& to, const Element& triangle,
  glm::dvec3& at);

} // namespace medial
