#pragma once

#include "options.h"

#include "medial/ranks.h"

namespace medial::app
{

/// Computes the field of a mesh on several processes, each for its part of the grid, into a .pvti
/// file with a piece for each. The first rank reads the mesh and hands out its triangles. Every
/// rank calls it.
/// @throws Failure on every rank, with the message of the first rank that failed.
void runOnRanks(const Options& options, Communicator& communicator);

} // namespace medial::app
