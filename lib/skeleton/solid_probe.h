#pragma once

#include "query/distance_query.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <vector>

namespace medial
{

/// Exact questions about the inside of a solid, in local coordinates. Several threads may ask at
/// once.
class SolidProbe
{
public:
  explicit SolidProbe(const DistanceQuery& query)
    : query_(query)
  {
  }

  /// For questions about places that are close to each other, one after the other.
  using Search = DistanceQuery::Search;
  Search search() const { return Search(query_); }

  /// Returns the distance to the surface.
  double radius(const glm::dvec3& x) const;
  /// Returns the distances of points along a curve to the surface.
  std::vector<double> radii(const std::vector<glm::dvec3>& points) const;

  /// Returns the nearest point of the surface.
  glm::dvec3 closest(const glm::dvec3& x) const;

  /// Returns the middle of the solid's cross-section near a point: the centre of the circle nearest
  /// to what is the closest of the surface to points around it.
  /// @param tangent unit vector normal to the cross-section.
  static glm::dvec3 middleAcross(Search& search, const glm::dvec3& x, const glm::dvec3& tangent);
  /// Returns the place near a point where the radius is largest in its cross-section.
  /// @param tangent unit vector normal to the cross-section.
  /// @param precision how near the place is wanted.
  static glm::dvec3 widestAcross(Search& search, const glm::dvec3& x, const glm::dvec3& tangent,
    double precision);
  /// The same in space, by a ball.
  glm::dvec3 middle(const glm::dvec3& x) const;

  /// Whether a point is inside. Much slower than radius() where the surface has holes.
  bool inside(const glm::dvec3& x) const;

  /// Returns the length at which a branch along a curve ends: where the radius begins to fall by
  /// half of the length or more.
  /// @param at returns the curve's position, for lengths in [low, high].
  /// @param step length within which there are no two such places.
  template <typename At>
  double end(const At& at, double low, double high, double step) const
  {
    const auto potential = [&](double s) { return this->radius(at(s)) + 0.5 * s; };
    double best = low;
    double bestPotential = potential(low);
    const int count = static_cast<int>((high - low) / step);
    for (int i = 1; i <= count; ++i)
    {
      const double here = potential(low + i * step);
      if (here > bestPotential)
      {
        best = low + i * step;
        bestPotential = here;
      }
    }
    double left = std::max(low, best - step);
    double right = std::min(high, best + step);
    for (int i = 0; i < kHalvings; ++i)
    {
      const double a = left + (right - left) / 3.0;
      const double b = right - (right - left) / 3.0;
      if (potential(a) < potential(b))
      {
        left = a;
      }
      else
      {
        right = b;
      }
    }
    return 0.5 * (left + right);
  }

  /// Returns how far one can go along a line from a point inside without leaving the solid, at
  /// most `high`. No gap is passed over unless it is narrower than 1e-5 of that.
  double wayOut(const glm::dvec3& from, const glm::dvec3& direction, double high) const;

private:
  static constexpr int kHalvings = 16;

  const DistanceQuery& query_;
};

} // namespace medial
