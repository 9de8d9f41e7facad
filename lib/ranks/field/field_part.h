#pragma once

#include "medial/grid.h"
#include "medial/side.h"
#include "ranks/collective.h"

#include <glm/glm.hpp>

#include <cstddef>
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

/// Adds to the field of this rank what others have around, and drops sites that are not next to the
/// side: they become 0. Every rank calls it.
/// @param own what this rank has computed.
/// @param wanted by all ranks, each with what it has itself.
/// @param side that is looked at.
FieldPart extendedPart(Communicator& communicator, FieldPart own, const std::vector<Extent>& wanted,
  Side side);

/// Returns the index of a point in an extent that has it, x fastest.
inline std::size_t pointIndex(const Extent& extent, const glm::ivec3& point)
{
  const auto row = static_cast<std::size_t>(point.z - extent.min[2]) * extent.size(1) +
    static_cast<std::size_t>(point.y - extent.min[1]);
  return row * extent.size(0) + static_cast<std::size_t>(point.x - extent.min[0]);
}

/// Returns the point of an extent that has an index.
inline glm::ivec3 pointAt(const Extent& extent, std::size_t index)
{
  const std::size_t row = index / extent.size(0);
  return { extent.min[0] + static_cast<int>(index % extent.size(0)),
    extent.min[1] + static_cast<int>(row % extent.size(1)),
    extent.min[2] + static_cast<int>(row / extent.size(1)) };
}

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
      std::size_t there = pointIndex(outer, { inner.min[0], y, z });
      for (int x = inner.min[0]; x <= inner.max[0]; ++x)
      {
        visit(there++, at++);
      }
    }
  }
}

} // namespace medial
