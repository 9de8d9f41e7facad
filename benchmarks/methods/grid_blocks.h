#pragma once

#include "medial/grid.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

// The order in which trees are queried for the whole grid: the answer of one query is a good first
// guess for the next, and the caches stay warm.
namespace medial::benchmark
{

/// Blocks of up to 8 x 8 x 8 grid points that cover the grid, along a Morton curve.
std::vector<Extent> mortonBlocks(const Grid& grid);

/// Index of a grid point in arrays, x fastest.
inline std::size_t pointIndex(const Grid& grid, int i, int j, int k)
{
  const auto nx = static_cast<std::size_t>(grid.dimensions[0]);
  const auto ny = static_cast<std::size_t>(grid.dimensions[1]);
  return (static_cast<std::size_t>(k) * ny + static_cast<std::size_t>(j)) * nx +
    static_cast<std::size_t>(i);
}

/// Calls visit(i, j, k) for the points of a block; each is a grid neighbour of the one before.
template <class Visit>
void serpentine(const Extent& block, Visit&& visit)
{
  bool forwardX = true;
  bool forwardY = true;
  for (int k = block.min[2]; k <= block.max[2]; ++k, forwardY = !forwardY)
  {
    for (int row = 0; row < block.size(1); ++row, forwardX = !forwardX)
    {
      const int j = forwardY ? block.min[1] + row : block.max[1] - row;
      for (int step = 0; step < block.size(0); ++step)
      {
        visit(forwardX ? block.min[0] + step : block.max[0] - step, j, k);
      }
    }
  }
}

} // namespace medial::benchmark
