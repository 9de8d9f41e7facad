#pragma once

#include <glm/glm.hpp>

namespace medial
{

/// Returns the place near a point where the distance to the surface is largest in the point's
/// cross-section: away from the closest point of the surface, by ever shorter steps. Between two
/// walls they end in the middle.
/// @param tangent unit vector normal to the cross-section.
/// @param precision how near to that place the answer is wanted; steps end below it.
/// @param closest returns the point of the surface that is closest to a place.
template <typename Closest>
glm::dvec3 widestPlace(const glm::dvec3& x, const glm::dvec3& tangent, double precision,
  const Closest& closest)
{
  constexpr double kFirstStep = 0.2;
  constexpr double kShorter = 0.75;
  constexpr int kMaxSteps = 24;
  glm::dvec3 place = x;
  double step = kFirstStep * glm::distance(closest(x), x);
  for (int i = 0; i < kMaxSteps && step > precision; ++i)
  {
    glm::dvec3 away = place - closest(place);
    away -= glm::dot(away, tangent) * tangent;
    const double length = glm::length(away);
    if (length > 0.0)
    {
      place += away * (step / length);
    }
    step *= kShorter;
  }
  return place;
}

} // namespace medial
