#pragma once

#include <cstddef>
#include <limits>
#include <vector>

namespace medial
{

/// Thickness at several places, points of a mesh or centres of its triangles.
struct PlaceValues
{
  explicit PlaceValues(std::size_t count)
    : values(count, std::numeric_limits<float>::quiet_NaN())
    , atEdge(count, 0)
  {
  }

  std::vector<float> values; ///< world units, NaN where there is none
  std::vector<char> atEdge;  ///< whether the value is that of a convex edge or tip
};

} // namespace medial
