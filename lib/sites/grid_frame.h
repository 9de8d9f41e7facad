#pragma once

#include "medial/grid.h"

#include <glm/glm.hpp>

namespace medial
{

/// The local coordinates that sites, culling and engines compute in. The origin is the middle of
/// the grid and the unit its finest spacing, so single precision suffices wherever the mesh lies
/// and however large it is.
struct GridFrame
{
  glm::dvec3 centre; ///< world position of the origin
  double unit;       ///< world units per local unit
  glm::dvec3 first;  ///< grid point (0,0,0), local coordinates
  glm::dvec3 step;   ///< distance of neighbouring grid points, local units, each >= 1

  explicit GridFrame(const Grid& grid);

  glm::dvec3 toFrame(const Point3& world) const;
  Point3 toWorld(const glm::dvec3& frame) const;
  glm::dvec3 sample(const glm::dvec3& index) const { return first + index * step; }
};

} // namespace medial
