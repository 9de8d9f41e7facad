#pragma once

#include "culling/group_list.h"
#include "medial/grid.h"
#include "sites/grid_frame.h"

#include <glm/glm.hpp>

#include <algorithm>

namespace medial
{

/// Calls visit(part) for the parts of an extent that start at multiples of a size from its corner,
/// x fastest.
template <typename Visit>
void visitParts(const Extent& extent, int size, const Visit& visit)
{
  Extent part;
  const auto cut = [&](int axis, int from)
  {
    part.min[axis] = from;
    part.max[axis] = std::min(from + size - 1, extent.max[axis]);
  };
  for (int k = extent.min[2]; k <= extent.max[2]; k += size)
  {
    cut(2, k);
    for (int j = extent.min[1]; j <= extent.max[1]; j += size)
    {
      cut(1, j);
      for (int i = extent.min[0]; i <= extent.max[0]; i += size)
      {
        cut(0, i);
        visit(part);
      }
    }
  }
}

/// Returns the box around the grid points of an extent.
inline FrameBox hullOf(const Extent& extent, const GridFrame& frame)
{
  const glm::dvec3 low(extent.min[0], extent.min[1], extent.min[2]);
  const glm::dvec3 high(extent.max[0], extent.max[1], extent.max[2]);
  return { glm::vec3(frame.sample(0.5 * (low + high))),
    glm::vec3(0.5 * (high - low) * frame.step) };
}

} // namespace medial
