#pragma once

#include "base/huge_pages.h"
#include "field/tile_field.h"
#include "medial/grid.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace medial
{

/// The closest sites of a slab and of the slice below it, in host memory, for the selection of
/// crossings.
class SlabField
{
public:
  /// Starts a slab. The last slice of the slab before becomes the slice below.
  /// @param inside whether points count as inside until they are stored.
  void begin(const Extent& slab, bool inside = false);
  /// Stores the slab's part of a tile. Slabs begin where tiles do along x. Several threads may call
  /// it at once for different tiles.
  void store(const Extent& tile, const TileField& field);

  /// Stores the whole slab, slice by slice, x fastest.
  /// @param sides negative inside; only the sign counts.
  void store(const std::int32_t* sites, const float* sides);

  const Extent& extent() const { return extent_; }
  /// Whether slot 0 holds the slice below extent().min[2].
  bool carried() const { return carried_; }
  /// Number of slots in use: slot 0 and one for each slice of the slab.
  int slots() const { return 1 + extent_.size(2); }

  /// Returns the closest sites of a row of grid points along x.
  const std::int32_t* sites(int slot, int row) const { return &sites_[this->index(slot, row)]; }
  /// Returns which grid points of a row along x are inside, as bits, the lowest first. One more
  /// byte follows the row.
  const std::uint8_t* inside(int slot, int row) const
  {
    return &inside_[this->insideIndex(slot, row)];
  }

private:
  std::size_t index(int slot, int row) const
  {
    return (static_cast<std::size_t>(slot) * extent_.size(1) + row) * extent_.size(0);
  }
  std::size_t insideIndex(int slot, int row) const
  {
    const int bytes = (extent_.size(0) + TileField::kRow - 1) / TileField::kRow + 1;
    return (static_cast<std::size_t>(slot) * extent_.size(1) + row) * bytes;
  }

  Extent extent_;
  bool begun_ = false;
  bool carried_ = false;
  ZeroedVector<std::int32_t> sites_; ///< slot by slot, x fastest; old where nothing was stored
  std::vector<std::uint8_t> inside_; ///< a byte for each TileField::kRow of a row
};

} // namespace medial
