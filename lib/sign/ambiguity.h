#pragma once

#include "base/checkpoint.h"
#include "medial/grid.h"
#include "sign/closed_surface.h"
#include "sign/row_crossings.h"
#include "sign/winding_number.h"
#include "sites/grid_frame.h"

#include <array>
#include <vector>

namespace medial
{

/// Some points of a grid.
struct GridSample
{
  GridFrame frame;
  Extent extent;

  /// Takes every n-th point of a grid, from the middle of the first n on.
  GridSample(const GridFrame& whole, const Grid& grid, int maxPoints);
};

/// A share of ambiguous points above this, in a sample of few points, leaves no doubt.
constexpr double kNoDoubt = 0.05;

/// Returns samples of few points and of more.
std::array<GridSample, 2> samplesOf(const GridFrame& frame, const Grid& grid);

/// Returns the share of a sample's points at which the winding number of an open surface is between
/// 1/4 and 3/4. Uses the threads of the current arena.
/// @param closed what rowCrossings() finds of the surface with its lids.
double ambiguousShareOf(const GridSample& sample, const std::vector<SliceCrossings>& closed,
  const WindingNumber& lids, const Checkpoint& checkpoint);

/// Returns the share of a grid's points at which the winding number of an open surface is between
/// 1/4 and 3/4, so that it does not tell inside from outside. It is estimated from at most 16
/// points along each axis, and from 8 where these find it at more than 5 %. Uses the threads of the
/// current arena.
/// @param closed the surface with its lids.
double ambiguousShare(const TriangleChain& closed, const WindingNumber& lids,
  const GridFrame& frame, const Grid& grid, const Checkpoint& checkpoint);

} // namespace medial
