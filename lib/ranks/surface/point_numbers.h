#pragma once

#include "medial/ranks.h"
#include "ranks/collective.h"

#include <vector>

namespace medial
{

/// Numbers the points of a surface in pieces, equal ones alike: in the order of their lowest
/// numbers in the pieces. Every rank calls it.
/// @param offsets receives the numbers of ranks' first points.
/// @return the numbers of the piece's points.
/// @throws Error InvalidInput if a number that counts has two positions, on ranks whose pieces have
///   it, or if there are too many points.
std::vector<int> numberPoints(Communicator& communicator, const SurfacePiece& piece,
  RankOffsets& offsets);

} // namespace medial
