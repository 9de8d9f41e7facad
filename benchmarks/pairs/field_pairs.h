#pragma once

#include "output/table.h"
#include "pairs/moving_pair.h"

namespace medial::benchmark
{

/// Lets the paper's way, distance fields where two meshes come close, take turns with exact
/// queries, and computes the same fields by the HAVOC-style baseline in some frames.
/// @param quick with few grid points.
/// @return a row for every number of grid points along the longest side.
Table raceFields(const MovingPair& pair, int rounds, bool quick);

} // namespace medial::benchmark
