#pragma once

#include "axis/bisector.h"
#include "medial/ranks.h"
#include "medial/side.h"
#include "ranks/axis/axis_patch.h"
#include "ranks/axis/corner_numbers.h"
#include "ranks/field/grid_share.h"
#include "thinning/thinned_axis.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace medial
{

/// The axis of one solid in a rank's part of the grid and around.
struct SolidPiece
{
  Side side = Side::Both;
  std::vector<std::int64_t> numbers; ///< of its points, ascending
  ThinnedAxis axis;
  std::vector<std::uint8_t> own; ///< for each point not 0 if it is this rank's

  /// Returns the index of a point, or the number of points if it is not here.
  std::size_t find(std::int64_t number) const;
  /// Returns a cell by the numbers of its points.
  template <std::size_t Count>
  NumberedCorners numbered(const std::array<std::int64_t, Count>& cell) const
  {
    NumberedCorners corners{ -1, -1, -1, -1 };
    std::transform(cell.begin(), cell.end(), corners.begin(),
      [this](std::int64_t p) { return numbers[p]; });
    return corners;
  }
};

/// Where a point has come to.
struct ChangedCorner
{
  std::int64_t number; ///< as CornerNumbers
  BisectorPoint point;
};

/// How far positions that have changed are told, grid cells: cells use points one away, and what
/// is around these decides on features.
constexpr int kTold = 2;

/// Moves points of rims back until every cell has an area or a length, as keepCellsSound() does in
/// one process: the first rank gets the cells whose points have moved. Every rank calls it.
/// @param before the points before this rank moved its own.
void keepSound(Communicator& communicator, const GridShare& share, const CornerNumbers& corners,
  const std::vector<BisectorPoint>& before, SolidPiece& solid);

/// Returns the cells of a rank, without attributes but features. Every rank calls it.
/// @param points receives those of the piece, local coordinates.
AxisPiece pieceOf(Communicator& communicator, const CornerNumbers& corners,
  const std::vector<SolidPiece>& solids, BisectorPoints& points);

} // namespace medial
