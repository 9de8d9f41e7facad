#include "sign/side_parts.h"

#include "base/extents.h"

#include <tbb/parallel_for.h>

#include <algorithm>

namespace medial
{

SideParts::SideParts(const InsideRows& inside, Side side, const Extent& extent, const Extent& whole,
  int size, int margin)
  : extent_(extent)
  , whole_(whole)
  , size_(size)
  , margin_(margin)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    first_[axis] = 0;
    first_[axis] = this->partAt(axis, extent.min[axis]);
    count_[axis] = this->partAt(axis, extent.max[axis]) + 1;
  }
  marks_.resize(static_cast<std::size_t>(count_[0]) * count_[1] * count_[2], 0);
  const Extent points = grown(extent, margin, whole);
  tbb::parallel_for(0, count_[2], [&](int layer) { this->markLayer(inside, side, points, layer); });
}

/// Marks the parts of a layer.
/// @param points those that may be within the margin of points that count.
void SideParts::markLayer(const InsideRows& inside, Side side, const Extent& points, int layer)
{
  const int begin = whole_.min[2] + (first_[2] + layer) * size_;
  const int first = std::max(begin, extent_.min[2]) - margin_;
  const int last = std::min(begin + size_ - 1, extent_.max[2]) + margin_;
  for (int k = std::max(first, points.min[2]); k <= std::min(last, points.max[2]); ++k)
  {
    for (int j = points.min[1]; j <= points.max[1]; ++j)
    {
      inside.visitRuns({ points.min[0], j, k }, points.size(0),
        [&](int runBegin, int runEnd, bool isInside)
        {
          if (side == Side::Both || isInside == (side == Side::Interior))
          {
            this->markRun(points.min[0] + runBegin, points.min[0] + runEnd - 1, j, layer);
          }
        });
    }
  }
}

/// Marks the parts of a layer within the margin of a run of points.
void SideParts::markRun(int first, int last, int j, int layer)
{
  const auto partsAround = [&](int axis, int low, int high)
  {
    return std::array<int, 2>{ this->partAt(axis, std::max(low - margin_, extent_.min[axis])),
      this->partAt(axis, std::min(high + margin_, extent_.max[axis])) };
  };
  const auto [left, right] = partsAround(0, first, last);
  const auto [front, back] = partsAround(1, j, j);
  for (int y = front; y <= back; ++y)
  {
    std::uint8_t* const row =
      &marks_[(static_cast<std::size_t>(layer) * count_[1] + y) * count_[0]];
    std::fill(row + left, row + right + 1, std::uint8_t{ 1 });
  }
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
