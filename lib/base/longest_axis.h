#pragma once

#include "medial/grid.h"

#include <glm/glm.hpp>

namespace medial
{

/// Returns the axis along which a box is longest; the first of equal ones.
inline int longestAxis(const glm::dvec3& size)
{
  const int xOrY = size.y > size.x ? 1 : 0;
  return size.z > size[xOrY] ? 2 : xOrY;
}

inline int longestAxis(const Extent& extent)
{
  return longestAxis(glm::dvec3(extent.size(0), extent.size(1), extent.size(2)));
}

} // namespace medial
