#pragma once

#include "sites/local_coordinates.h"

namespace medial
{

/// A grid in local coordinates: centred on it, in units of its finest spacing.
struct GridFrame : LocalCoordinates
{
  glm::dvec3 first; ///< local position of grid point (0,0,0)
  glm::dvec3 step;  ///< local distance of neighbouring grid points, each >= 1

  explicit GridFrame(const Grid& grid);

  glm::dvec3 sample(const glm::dvec3& index) const { return first + index * step; }
};

} // namespace medial
