#include "sign/side_parts.h"

#include <tbb/parallel_for.h>

#include <algorithm>

namespace medial
{

SideParts::SideParts(const InsideRows& inside, Side side, const Extent& extent, const Extent& whole,
  int size)
  : extent_(extent)
  , whole_(whole)
  , size_(size)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    first_[axis] = 0;
    first_[axis] = this->partAt(axis, extent.min[axis]);
    count_[axis] = this->partAt(axis, extent.max[axis]) + 1;
  }
  marks_.resize(static_cast<std::size_t>(count_[0]) * count_[1] * count_[2], 0);
  tbb::parallel_for(0, count_[2],
    [&](int layer)
    {
      const int begin = whole_.min[2] + (first_[2] + layer) * size_;
      const int last = std::min(begin + size_ - 1, extent_.max[2]);
      for (int k = std::max(begin, extent_.min[2]); k <= last; ++k)
      {
        for (int j = extent_.min[1]; j <= extent_.max[1]; ++j)
        {
          this->markRow(inside, side, j, k);
        }
      }
    });
}

void SideParts::markRow(const InsideRows& inside, Side side, int j, int k)
{
  std::uint8_t* const row =
    &marks_[(static_cast<std::size_t>(this->partAt(2, k)) * count_[1] + this->partAt(1, j)) *
      count_[0]];
  inside.visitRuns({ extent_.min[0], j, k }, extent_.size(0),
    [&](int begin, int end, bool isInside)
    {
      if (side == Side::Both || isInside == (side == Side::Interior))
      {
        std::fill(row + this->partAt(0, extent_.min[0] + begin),
          row + this->partAt(0, extent_.min[0] + end - 1) + 1, std::uint8_t{ 1 });
      }
    });
}

bool SideParts::meets(const Extent& parts) const
{
  std::array<int, 3> low;
  std::array<int, 3> high;
  for (int axis = 0; axis < 3; ++axis)
  {
    low[axis] = std::max(this->partAt(axis, parts.min[axis]), 0);
    high[axis] = std::min(this->partAt(axis, parts.max[axis]), count_[axis] - 1);
  }
  for (int z = low[2]; z <= high[2]; ++z)
  {
    for (int y = low[1]; y <= high[1]; ++y)
    {
      const auto row =
        marks_.begin() + (static_cast<std::ptrdiff_t>(z) * count_[1] + y) * count_[0];
      if (std::find(row + low[0], row + high[0] + 1, 1) != row + high[0] + 1)
      {
        return true;
      }
    }
  }
  return false;
}

} // namespace medial
