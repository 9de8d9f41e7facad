#pragma once

#include "axis/bisector_point.h"

#include <glm/glm.hpp>

#include <cmath>

namespace medial
{

/// Neighbouring facets of a smooth surface meet at no more than this angle, degrees.
constexpr double kMaxTurn = 25.0;

/// Where a point sees its closest pair.
struct PairDirections
{
  glm::dvec3 towardsA{ 0.0 }; ///< unit vectors
  glm::dvec3 towardsB{ 0.0 };
  double radius = 0.0;
};

/// @param point with a radius above 0.
inline PairDirections directionsOf(const BisectorPoint& point)
{
  const double radius = point.radius();
  return { (point.a.point - point.position) / radius,
    glm::normalize(point.b.point - point.position), radius };
}

/// How the directions to two closest pairs belong to one sheet.
enum class Match
{
  None,
  Same,
  Swapped ///< the second pair is in the other order
};

/// @param cosTurn cosine of the largest turn of either direction between the pairs.
inline Match matchOf(const PairDirections& one, const PairDirections& other, double cosTurn)
{
  const double same[2] = { glm::dot(one.towardsA, other.towardsA),
    glm::dot(one.towardsB, other.towardsB) };
  const double swapped[2] = { glm::dot(one.towardsA, other.towardsB),
    glm::dot(one.towardsB, other.towardsA) };
  if (same[0] + same[1] < swapped[0] + swapped[1])
  {
    return swapped[0] >= cosTurn && swapped[1] >= cosTurn ? Match::Swapped : Match::None;
  }
  return same[0] >= cosTurn && same[1] >= cosTurn ? Match::Same : Match::None;
}

/// Whether two points are on one sheet, as far as their directions tell: in either order, each of
/// them turns by kMaxTurn at most from that of the sheet.
inline bool onOneSheet(const PairDirections& one, const PairDirections& other)
{
  static const double kCosTurn = std::cos(2.0 * glm::radians(kMaxTurn));
  const auto near = [](const glm::dvec3& a, const glm::dvec3& b)
  { return glm::dot(a, b) >= kCosTurn; };
  return (near(one.towardsA, other.towardsA) && near(one.towardsB, other.towardsB)) ||
    (near(one.towardsA, other.towardsB) && near(one.towardsB, other.towardsA));
}

} // namespace medial
