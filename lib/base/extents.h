#pragma once

#include "medial/grid.h"

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

///@{
/// Returns an extent with some layers of points around it; itself if it is empty.
/// @param whole all of the grid, beyond which there are no points.
inline Extent grown(Extent extent, int layers)
{
  if (extent.empty())
  {
    return extent;
  }
  for (int axis = 0; axis < 3; ++axis)
  {
    extent.min[axis] -= layers;
    extent.max[axis] += layers;
  }
  return extent;
}

inline Extent grown(const Extent& extent, int layers, const Extent& whole)
{
  return extent.empty() ? extent : commonPart(grown(extent, layers), whole);
}
///@}

/// Returns an extent with some layers of points behind its last ones along each axis, as far as the
/// grid has them; itself if it is empty.
inline Extent grownUpwards(Extent extent, int layers, const Extent& whole)
{
  if (extent.empty())
  {
    return extent;
  }
  for (int axis = 0; axis < 3; ++axis)
  {
    extent.max[axis] = std::min(extent.max[axis] + layers, whole.max[axis]);
  }
  return extent;
}

/// Whether a grid point is in an extent.
inline bool hasPoint(const Extent& extent, const glm::ivec3& point)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    if (point[axis] < extent.min[axis] || point[axis] > extent.max[axis])
    {
      return false;
    }
  }
  return true;
}

/// Whether all points of a grid cell are in an extent.
/// @param cell its lowest point.
inline bool hasCell(const Extent& extent, const glm::ivec3& cell)
{
  return hasPoint(extent, cell) && hasPoint(extent, cell + 1);
}

} // namespace medial
