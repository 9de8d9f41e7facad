#pragma once

#include "medial/grid.h"

#include <glm/glm.hpp>

namespace medial
{

/// The coordinates that sites, culling and GPU compute in: centred on the grid, in units of its
/// finest spacing, so that single precision serves wherever the mesh lies and however large it is.
struct GridFrame
{
  glm::dvec3 centre; ///< world position of the frame's origin
  double unit;       ///< world units per frame unit
  glm::dvec3 first;  ///< frame position of grid point (0,0,0)
  glm::dvec3 step;   ///< frame distance of neighbouring grid points, each >= 1

  explicit GridFrame(const Grid& grid);

  glm::dvec3 toFrame(const Point3& world) const;
  Point3 toWorld(const glm::dvec3& frame) const;
  glm::dvec3 sample(const glm::dvec3& index) const { return first + index * step; }
};

} // namespace medial
