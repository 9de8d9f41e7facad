#pragma once

#include <glm/glm.hpp>

#include <cstddef>

// Grid cells see the surface in some directions; close ones are one side of it.
namespace medial
{

/// Sites seen in directions that differ by less, degrees, are one side where sheets between sides
/// are followed.
constexpr double kOneSideAngle = 12.5;
/// The same where sheets between sides are looked for: directions may differ from that of a side by
/// as much on either hand.
constexpr double kOneSideSpan = 2.0 * kOneSideAngle;

/// Returns which of some directions of unit length is closest to another; -1 if all differ by more
/// than an angle.
/// @param way of any length but 0.
/// @param cosAngle cosine of the angle.
template <typename DirectionOf>
int closestDirection(std::size_t count, const DirectionOf& directionOf, const glm::dvec3& way,
  double cosAngle)
{
  int best = -1;
  double bestDot = cosAngle * glm::length(way);
  for (std::size_t i = 0; i < count; ++i)
  {
    const double dot = glm::dot(directionOf(i), way);
    if (dot >= bestDot)
    {
      best = static_cast<int>(i);
      bestDot = dot;
    }
  }
  return best;
}

} // namespace medial
