#pragma once

#include "axis/bisector_point.h"
#include "ranks/collective.h"
#include "thinning/thinned_axis.h"

#include <array>
#include <cstdint>
#include <vector>

namespace medial
{

/// A point of an axis before and after it has moved.
struct MovedCorner
{
  std::int64_t number; ///< as CornerNumbers
  BisectorPoint before;
  BisectorPoint after;
};

/// A quad or a line, by the numbers of its points; -1 for those that it has not.
using NumberedCorners = std::array<std::int64_t, 4>;

/// Some cells of an axis in pieces, which the first rank brings together in the order of one
/// process. It is empty elsewhere.
struct AxisPatch
{
  /// Every rank calls it.
  /// @param corners those of this rank, of cells of any ranks; several ranks may have the same.
  /// @param cells of this rank, in their order; their corners come from some rank.
  AxisPatch(Communicator& communicator, const std::vector<MovedCorner>& corners,
    const std::vector<NumberedCorners>& cells);

  std::vector<std::int64_t> numbers; ///< of the points, ascending
  std::vector<BisectorPoint> before; ///< the points before they moved
  ThinnedAxis axis;
};

} // namespace medial
