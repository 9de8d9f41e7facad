#pragma once

#include "sites/local_coordinates.h"

namespace medial
{

/// A grid in local coordinates: the origin is its middle, the unit its finest spacing.
struct GridFrame : LocalCoordinates
{
  glm::dvec3 first; ///< grid point (0,0,0), local coordinates
  glm::dvec3 step;  ///< distance of neighbouring grid points, local units, each >= 1

  explicit GridFrame(const Grid& grid);

  glm::dvec3 sample(const glm::dvec3& index) const { return first + index * step; }
  /// Distance of the farthest grid point from the origin, local units.
  double reach() const { return glm::length(first); }
};

} // namespace medial
