#pragma once

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
  void begin(const Extent& slab);
  /// Stores the slab's part of a tile. Several threads may call it at once for different tiles.
  void store(const Extent& tile, const TileField& field);

  /// Stores the whole slab, slice by slice, x fastest.
  /// @param sides negative inside.
  void store(const std::int32_t* sites, const float* sides);

  const Extent& extent() const { return extent_; }
  /// Whether slot 0 holds the slice below extent().min[2].
  bool carried() const { return carried_; }
  /// Number of slots in use: slot 0 and one for each slice of the slab.
  int slots() const { return 1 + extent_.size(2); }

  /// Returns the closest sites of a row of grid points along x.
  const std::int32_t* sites(int slot, int row) const { return &sites_[this->index(slot, row)]; }
  /// Returns values that are negative inside; only the sign counts.
  const float* sides(int slot, int row) const { return &sides_[this->index(slot, row)]; }

private:
  std::size_t index(int slot, int row) const
  {
    return (static_cast<std::size_t>(slot) * extent_.size(1) + row) * extent_.size(0);
  }

  Extent extent_;
  bool begun_ = false;
  bool carried_ = false;
  std::vector<std::int32_t> sites_; ///< slot by slot, x fastest
  std::vector<float> sides_;
};

} // namespace medial
