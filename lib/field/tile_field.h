#pragma once

#include "medial/grid.h"

#include <algorithm>
#include <cstdint>

namespace medial
{

/// Slices [begin, end) of a tile, counted from its first.
struct SliceRange
{
  int begin;
  int end;

  /// Those of a tile that lie in a slab.
  static SliceRange common(const Extent& tile, const Extent& slab)
  {
    return { std::max(slab.min[2] - tile.min[2], 0),
      std::min(slab.max[2], tile.max[2]) - tile.min[2] + 1 };
  }

  bool contains(int slice) const { return slice >= begin && slice < end; }
};

/// The closest sites of the grid points of one tile, x fastest, in rows of kRow.
struct TileField
{
  static constexpr int kRow = 8;
  static constexpr int kPoints = kRow * kRow * kRow;
  /// Squared distance, local units, up to which single precision tells sites and distances apart to
  /// 1e-3. Grids around a mesh have hardly any larger ones.
  static constexpr float kFarSquared = 4096.0f * 4096.0f;

  static int index(int i, int j, int k) { return (k * kRow + j) * kRow + i; }

  alignas(32) float squared[kPoints]; ///< squared distance, local units
  alignas(32) float side[kPoints];    ///< negative inside; only the sign counts
  alignas(32) std::int32_t site[kPoints];
};

} // namespace medial
