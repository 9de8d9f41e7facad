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

/// Returns the points that two extents share.
inline Extent commonPart(const Extent& a, const Extent& b)
{
  Extent common;
  for (int axis = 0; axis < 3; ++axis)
  {
    common.min[axis] = std::max(a.min[axis], b.min[axis]);
    common.max[axis] = std::min(a.max[axis], b.max[axis]);
  }
  return common;
}

/// Returns the smallest extent around another that ends where parts of a grid do that start at
/// multiples of a size.
/// @param whole all of the grid.
inline Extent wholeParts(const Extent& extent, int size, const Extent& whole)
{
  Extent parts;
  for (int axis = 0; axis < 3; ++axis)
  {
    parts.min[axis] = extent.min[axis] - (extent.min[axis] - whole.min[axis]) % size;
    const int last = (extent.max[axis] - whole.min[axis]) / size;
    parts.max[axis] = std::min(whole.min[axis] + (last + 1) * size - 1, whole.max[axis]);
  }
  return parts;
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
