#pragma once

#include "base/vectors.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <array>
#include <cstddef>

namespace medial
{

/// An upper bound of the distance to the surface in a plane: the distance and its slope at the last
/// places that were asked for (cutting planes: Kelley 1960). It is exact in a tube at once, as all
/// tangent planes of a cone meet in its tip, and between plane walls.
class DistanceCuts
{
public:
  /// @param slope of the distance at the place; of unit length at most.
  void add(const glm::dvec2& place, double distance, const glm::dvec2& slope);

  /// Returns where the bound is largest within a reach of a place; along two walls that part it
  /// goes the less far the less they do.
  glm::dvec2 widest(const glm::dvec2& from, double reach) const;

private:
  static constexpr std::size_t kMost = 5;
  struct Place
  {
    glm::dvec2 place;
    double value; ///< the distance by the cuts, less what the way there costs
  };
  /// The distance at `at` is height + dot(slope, at).
  struct Cut
  {
    double height;
    glm::dvec2 slope;
  };

  double at(const glm::dvec2& place) const;
  void offer(const glm::dvec2& place, const glm::dvec2& from, double reach, Place& best) const;
  void offerRidge(const Cut& a, const Cut& b, const glm::dvec2& from, double reach,
    Place& best) const;
  void offerTip(const Cut& a, const Cut& b, const Cut& c, const glm::dvec2& from, double reach,
    Place& best) const;

  std::array<Cut, kMost> cuts_{};
  std::size_t count_ = 0;
  std::size_t next_ = 0;
};

/// Returns the place near a point where the distance to the surface is largest in the point's
/// cross-section, within that distance. Between two walls it is in the middle.
/// @param tangent unit vector normal to the cross-section.
/// @param precision how near to that place the answer is wanted.
/// @param closest returns the point of the surface that is closest to a place.
template <typename Closest>
glm::dvec3 widestPlace(const glm::dvec3& x, const glm::dvec3& tangent, double precision,
  const Closest& closest)
{
  constexpr double kReach = 0.2; // of the distance
  constexpr double kShorter = 0.7;
  constexpr int kMaxPlaces = 16;
  if (tangent == glm::dvec3(0.0))
  {
    return x;
  }
  const auto [u, v] = normalsTo(tangent);
  const auto inSpace = [&, u = u, v = v](const glm::dvec2& place)
  { return x + place.x * u + place.y * v; };
  DistanceCuts cuts;
  const auto ask = [&, u = u, v = v](const glm::dvec2& place)
  {
    const glm::dvec3 here = inSpace(place);
    const glm::dvec3 away = here - closest(here);
    const double distance = glm::length(away);
    if (distance > 0.0)
    {
      cuts.add(place, distance, glm::dvec2(glm::dot(away, u), glm::dot(away, v)) / distance);
    }
    return distance;
  };
  glm::dvec2 best(0.0);
  double distance = ask(best);
  const double farthest = distance;
  double reach = kReach * distance;
  for (int i = 1; i < kMaxPlaces; ++i)
  {
    glm::dvec2 next = cuts.widest(best, reach);
    next *= farthest / std::max(farthest, glm::length(next));
    const double way = glm::distance(next, best);
    if (way <= precision)
    {
      break;
    }
    const double found = ask(next);
    if (found > distance)
    {
      best = next;
      distance = found;
    }
    else
    {
      reach = kShorter * way;
    }
  }
  return inSpace(best);
}

} // namespace medial
