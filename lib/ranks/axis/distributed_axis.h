#pragma once

#include "medial/ranks.h"

#include <vector>

namespace medial
{

/// As computeMedialAxis(), with parts of the grid where ranks make the axis from its crossings,
/// besides those where they compute the field and find these.
/// @param axisExtents of all ranks; cover the grid, each point once. Without any they are cut so
///   that ranks have about as many crossings in their parts and around.
AxisPiece computeMedialAxis(Communicator& communicator, const SurfacePiece& piece, const Grid& grid,
  const std::vector<Extent>& extents, const std::vector<Extent>& axisExtents, FieldSink& sink,
  const MedialAxisOptions& options, RankCounts* counts = nullptr);

} // namespace medial
