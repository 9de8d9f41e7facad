#pragma once

#include "medial/grid.h"

#include <glm/glm.hpp>

namespace medial
{

/// The coordinates that sites, culling, queries and engines compute in: centred on what they are
/// about and in units of the finest length that counts, so that single precision serves wherever
/// the mesh lies and however large it is.
struct LocalCoordinates
{
  glm::dvec3 centre; ///< world position of the local origin
  double unit;       ///< world units per local unit

  /// For positions anywhere around a mesh, where there is no grid: the coordinates of the finest
  /// grid that may be laid around it, whose spacing is the unit. No such grid is made.
  ///
  /// @param bounds of the mesh, world units.
  /// @param margin of that grid, a share of the diagonal of the bounds. It has no other effect than
  ///   on the rounding of what is computed; callers keep theirs so that their results stay the same
  ///   to the last digit.
  static LocalCoordinates around(const Bounds& bounds, double margin);

  glm::dvec3 toLocal(const Point3& world) const;
  Point3 toWorld(const glm::dvec3& local) const;
};

} // namespace medial
