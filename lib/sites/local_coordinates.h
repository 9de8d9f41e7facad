#pragma once

#include "medial/grid.h"

#include <glm/glm.hpp>

namespace medial
{

/// The coordinates that sites, culling, queries and engines compute in. The origin is the middle of
/// the grid or mesh and the unit its finest length, so single precision suffices wherever the mesh
/// lies and however large it is.
struct LocalCoordinates
{
  glm::dvec3 centre; ///< world position of the local origin
  double unit;       ///< world units per local unit

  /// Returns the coordinates for positions anywhere around a mesh, if there is no grid. The unit is
  /// the spacing of the finest grid that is allowed around the mesh; no such grid is made.
  ///
  /// @param bounds of the mesh, world units.
  /// @param margin of that grid, as a share of the diagonal of the bounds. It only affects
  ///   rounding; callers keep theirs so that their results stay the same to the last digit.
  static LocalCoordinates around(const Bounds& bounds, double margin);

  glm::dvec3 toLocal(const Point3& world) const;
  Point3 toWorld(const glm::dvec3& local) const;
};

} // namespace medial
