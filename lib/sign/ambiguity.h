#pragma once

#include "base/checkpoint.h"
#include "medial/grid.h"
#include "sign/closed_surface.h"
#include "sign/winding_number.h"
#include "sites/grid_frame.h"

namespace medial
{

/// Returns the share of a grid's points at which the winding number of an open surface is between
/// 1/4 and 3/4, so that it does not tell inside from outside. It is estimated from at most 16
/// points along each axis, and from 8 where these find it at more than 5 %. Uses the threads of the
/// current arena.
/// @param closed the surface with its lids.
double ambiguousShare(const TriangleChain& closed, const WindingNumber& lids,
  const GridFrame& frame, const Grid& grid, const Checkpoint& checkpoint);

} // namespace medial
