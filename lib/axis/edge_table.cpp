#include "axis/edge_table.h"

#include <algorithm>

namespace medial
{

EdgeTable::EdgeTable(const std::vector<Side>& sides, std::size_t pointCount)
  : offsets_(pointCount + 1)
  , high_(sides.size())
{
  for (const Side& side : sides)
  {
    ++offsets_[std::min(side[0], side[1])];
  }
  std::size_t total = 0;
  for (std::size_t& offset : offsets_)
  {
    total += offset;
    offset = total; // ends; filling turns them into beginnings
  }
  for (const Side& side : sides)
  {
    high_[--offsets_[std::min(side[0], side[1])]] = std::max(side[0], side[1]);
  }
  for (std::size_t low = 0; low < pointCount; ++low)
  {
    std::sort(high_.begin() + static_cast<std::ptrdiff_t>(offsets_[low]),
      high_.begin() + static_cast<std::ptrdiff_t>(offsets_[low + 1]));
  }
}

std::size_t EdgeTable::count(const Side& side) const
{
  const std::int64_t low = std::min(side[0], side[1]);
  const auto range = std::equal_range(high_.begin() + static_cast<std::ptrdiff_t>(offsets_[low]),
    high_.begin() + static_cast<std::ptrdiff_t>(offsets_[low + 1]), std::max(side[0], side[1]));
  return static_cast<std::size_t>(range.second - range.first);
}

} // namespace medial
