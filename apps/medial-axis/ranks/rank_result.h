#pragma once

#include "options.h"
#include "ranks/rank_input.h"
#include "ranks/rank_thickness.h"
#include "result.h"

#include "medial/ranks.h"

#include <vector>

namespace medial::app
{

/// What a rank has computed.
struct RankComputed
{
  AxisPiece axis; ///< where it is wanted, as the thickness
  RankThickness thickness;
  RunStatistics statistics; ///< of its part, or of a whole axis
  RankCounts counts;
};

/// Brings together what ranks have computed, and measures the axis, as far as the options ask for
/// it. Every rank calls it.
/// @param extents of all ranks; empty where no grid is wanted.
/// @param computed gives up the thickness of the whole surface.
/// @return the result of one process, on every rank, without its mesh and its cells, but for what
///   files and limits of thickness need on the first.
/// @throws Failure on every rank.
Result resultOf(const Options& options, Communicator& communicator, const Share& share,
  const Grid& grid, const std::vector<Extent>& extents, RankComputed& computed);

} // namespace medial::app
