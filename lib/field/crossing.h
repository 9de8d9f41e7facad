#pragma once

#include "medial/side.h"

#include <glm/glm.hpp>

#include <cstddef>
#include <cstdint>

namespace medial
{

/// A grid edge that the medial axis crosses, from `voxel` to its neighbour along `axis`.
struct Crossing
{
  glm::ivec3 voxel;
  int axis;
  std::int32_t siteA; ///< closest site at the voxel
  std::int32_t siteB; ///< closest site at the neighbour
  bool inside;        ///< whether both ends are; false where the field has no sign
};

/// Which grid edges the medial axis crosses: those whose ends lie on the wanted side, with
/// directions to their closest points that differ by the separation angle or more (Foskey et al.
/// 2003), and closest points no nearer to each other than the ends.
struct CrossingSelection
{
  double angle; ///< min separation angle, degrees
  Side side;    ///< Both where the field has no sign
};

/// Gives an axis up that memory cannot hold, at the first slab that shows it. For engines, after
/// every slab.
/// @param crossings selected so far.
/// @throws Error OutOfMemory.
void requireRoomForAxis(std::size_t crossings);

} // namespace medial
