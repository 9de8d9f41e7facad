#include "field/engines/processor/slab_field.h"

#include "base/extents.h"
#include "base/simd.h"

#include <algorithm>

namespace medial
{
namespace
{

static_assert(TileField::kRow == kLanes);

/// Sets bits where values are negative, eight to a byte.
/// @param count number of values; bits beyond it are 0.
MEDIAL_VECTORISED void setNegative(const float* values, int count, std::uint8_t* target)
{
  for (; count >= kLanes; count -= kLanes, values += kLanes)
  {
    *target++ = static_cast<std::uint8_t>(bits(loaded(values) < 0.0f));
  }
  unsigned last = 0;
  for (int i = 0; i < count; ++i)
  {
    last |= values[i] < 0.0f ? 1u << i : 0u;
  }
  if (count > 0)
  {
    *target = static_cast<std::uint8_t>(last);
  }
}

} // namespace

void SlabField::begin(const Extent& slab, bool inside)
{
  carried_ = begun_;
  if (begun_)
  {
    const int last = extent_.size(2);
    std::copy_n(sites_.begin() + this->index(last, 0), this->index(1, 0), sites_.begin());
    std::copy_n(inside_.begin() + this->insideIndex(last, 0), this->insideIndex(1, 0),
      inside_.begin());
  }
  begun_ = true;
  extent_ = slab;
  sites_.resize(this->index(this->slots(), 0));
  inside_.resize(this->insideIndex(this->slots(), 0));
  std::fill(inside_.begin() + this->insideIndex(1, 0), inside_.end(),
    static_cast<std::uint8_t>(inside ? 0xff : 0));
}

void SlabField::store(const std::int32_t* sites, const float* sides)
{
  const std::size_t points = sites_.size() - this->index(1, 0);
  std::copy_n(sites, points, sites_.begin() + this->index(1, 0));
  const int width = extent_.size(0);
  for (int slot = 1; slot < this->slots(); ++slot)
  {
    for (int row = 0; row < extent_.size(1); ++row, sides += width)
    {
      setNegative(sides, width, &inside_[this->insideIndex(slot, row)]);
    }
  }
}

void SlabField::store(const Extent& tile, const TileField& field)
{
  const Extent part = commonPart(tile, extent_);
  const int skipped = part.min[0] - tile.min[0];
  const int first = part.min[0] - extent_.min[0];
  std::uint8_t inside[TileField::kPoints / kLanes];
  setNegative(field.side, TileField::kPoints, inside);
  for (int k = part.min[2]; k <= part.max[2]; ++k)
  {
    for (int j = part.min[1]; j <= part.max[1]; ++j)
    {
      const int slot = 1 + k - extent_.min[2];
      const int row = j - extent_.min[1];
      const int source = TileField::index(0, j - tile.min[1], k - tile.min[2]);
      std::copy_n(field.site + source + skipped, part.size(0),
        sites_.begin() + this->index(slot, row) + first);
      inside_[this->insideIndex(slot, row) + first / TileField::kRow] = inside[source / kLanes];
    }
  }
}

} // namespace medial
