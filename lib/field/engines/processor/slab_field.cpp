#include "field/engines/processor/slab_field.h"

#include <algorithm>

namespace medial
{

void SlabField::begin(const Extent& slab)
{
  carried_ = begun_;
  const std::size_t slice = static_cast<std::size_t>(slab.size(0)) * slab.size(1);
  if (begun_)
  {
    const std::size_t last = slice * extent_.size(2);
    std::copy_n(sites_.begin() + last, slice, sites_.begin());
    std::copy_n(sides_.begin() + last, slice, sides_.begin());
  }
  begun_ = true;
  extent_ = slab;
  sites_.resize(slice * this->slots());
  sides_.resize(slice * this->slots());
}

void SlabField::store(const std::int32_t* sites, const float* sides)
{
  const std::size_t points = sites_.size() - this->index(1, 0);
  std::copy_n(sites, points, sites_.begin() + this->index(1, 0));
  std::copy_n(sides, points, sides_.begin() + this->index(1, 0));
}

void SlabField::store(const Extent& tile, const TileField& field)
{
  const SliceRange slices = SliceRange::common(tile, extent_);
  for (int k = slices.begin; k < slices.end; ++k)
  {
    for (int j = 0; j < tile.size(1); ++j)
    {
      const std::size_t target =
        this->index(1 + tile.min[2] + k - extent_.min[2], tile.min[1] + j - extent_.min[1]) +
        (tile.min[0] - extent_.min[0]);
      const int source = TileField::index(0, j, k);
      std::copy_n(field.site + source, tile.size(0), sites_.begin() + target);
      std::copy_n(field.side + source, tile.size(0), sides_.begin() + target);
    }
  }
}

} // namespace medial
