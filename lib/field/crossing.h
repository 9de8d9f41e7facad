#pragma once

#include "medial/side.h"

#include <glm/glm.hpp>

#include <cstddef>
#include <cstdint>

namespace medial
{

class FieldTap;

/// A grid edge that the medial axis crosses. It leads from `voxel` to its neighbour along `axis`.
struct Crossing
{
  glm::ivec3 voxel;
  int axis;
  std::int32_t siteA; ///< closest site at the voxel
  std::int32_t siteB; ///< closest site at the neighbour
  bool inside;        ///< whether both ends are inside; false if the field has no sign
};

/// Which grid edges the medial axis crosses: those whose ends lie on the wanted side, have
/// directions to their closest points that differ by the separation angle or more (Foskey et al.
/// 2003), and have closest points no nearer to each other than the ends are.
struct CrossingSelection
{
  double angle;                  ///< minimum angle between the directions at the ends, degrees
  Side side;                     ///< Both if the field has no sign
  const FieldTap* tap = nullptr; ///< the sink, if it keeps the field for the axis
};

/// Gives up an axis that does not fit into memory, at the first slab that shows it. Engines call it
/// after every slab.
/// @param crossings number of crossings selected so far.
/// @throws Error OutOfMemory, and InvalidInput for more than kMaxCrossings.
void requireRoomForAxis(std::size_t crossings);

} // namespace medial
