#pragma once

#include "balls/ball_union.h"
#include "medial/grid.h"
#include "medial/ranks.h"

namespace medial
{

/// Sends to every rank the primitives that can matter to the reconstruction in its extent. Every
/// rank calls it.
/// @param own primitives of this rank; may be none.
/// @param extent of this rank; may be empty.
/// @return those that can matter in the extent, of all ranks one after the other; balls that are in
///   several pieces are there several times.
BallPrimitives nearPrimitives(Communicator& communicator, const BallPrimitives& own,
  const Grid& grid, const Extent& extent);

} // namespace medial
