#pragma once

#include "field/tile_field.h"
#include "medial/grid.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace medial
{

/// The closest sites of a slab in host memory, and of the slice below it: what crossings are
/// selected in.
class SlabField
{
public:
  /// Keeps the last slice of the slab before as the slice below.
  void begin(const Extent& slab);
  /// May be called from several threads at once for different tiles.
  void store(const Extent& tile, const TileField& field);

  const Extent& extent() const { return extent_; }
  /// Whether slot 0 holds the slice below extent().min[2].
  bool carried() const { return carried_; }
  /// Slots in use: the slab's slices follow slot 0.
  int slots() const { return 1 + extent_.size(2); }

  /// Closest sites of a row of grid points along x.
  const std::int32_t* sites(int slot, int row) const { return &sites_[this->index(slot, row)]; }
  /// Negative inside; only the sign means something.
  const float* sides(int slot, int row) const { return &sides_[this->index(slot, row)]; }

private:
  std::size_t index(int slot, int row) const
  {
    return (static_cast<std::size_t>(slot) * extent_.size(1) + row) * extent_.size(0);
  }

  Extent extent_;
  bool begun_ = false;
  bool carried_ = false;
  std::vector<std::int32_t> sites_; ///< slot after slot, x fastest, as are
  std::vector<float> sides_;
};

} // namespace medial
