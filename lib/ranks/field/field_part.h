#pragma once

#include "medial/grid.h"
#include "medial/side.h"
#include "ranks/collective.h"

#include <cstdint>
#include <vector>

namespace medial
{

/// The field at the points of a side and those next to them, in a part of a grid. Elsewhere points
/// are on the other side, at no distance.
struct FieldPart
{
  Extent extent;
  std::vector<float> distances;    ///< world units, x fastest
  std::vector<std::int32_t> sites; ///< numbers in the whole surface
};

/// Gives each rank the field of another part of the grid. Every rank calls it.
/// @param own what this rank has computed.
/// @param wanted by all ranks; some may be empty.
/// @param side that is looked at.
FieldPart exchangedPart(Communicator& communicator, FieldPart own,
  const std::vector<Extent>& wanted, Side side);

/// Calls visit(index in the outer extent, index in the inner one) for the points of an inner
/// extent, x fastest.
template <typename Visit>
void visitWithin(const Extent& inner, const Extent& outer, const Visit& visit)
{
  std::size_t at = 0;
  for (int z = inner.min[2]; z <= inner.max[2]; ++z)
  {
    for (int y = inner.min[1]; y <= inner.max[1]; ++y)
    {
      const std::int64_t row =
        (static_cast<std::int64_t>(z - outer.min[2]) * outer.size(1) + y - outer.min[1]) *
          outer.size(0) -
        outer.min[0];
      for (int x = inner.min[0]; x <= inner.max[0]; ++x)
      {
        visit(static_cast<std::size_t>(row + x), at++);
      }
    }
  }
}

} // namespace medial
