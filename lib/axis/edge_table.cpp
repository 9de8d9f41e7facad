#include "axis/edge_table.h"

#include <tbb/parallel_for.h>

#include <algorithm>

namespace medial
{

EdgeTable::EdgeTable(const std::vector<Edge>& edges, std::size_t pointCount)
  : offsets_(pointCount + 1)
  , high_(edges.size())
{
  for (const Edge& edge : edges)
  {
    ++offsets_[std::min(edge[0], edge[1])];
  }
  std::size_t total = 0;
  for (std::size_t& offset : offsets_)
  {
    total += offset;
    offset = total; // ends; filling turns them into beginnings
  }
  for (const Edge& edge : edges)
  {
    high_[--offsets_[std::min(edge[0], edge[1])]] = std::max(edge[0], edge[1]);
  }
  tbb::parallel_for(std::size_t{ 0 }, pointCount,
    [&](std::size_t low)
    {
      std::sort(high_.begin() + static_cast<std::ptrdiff_t>(offsets_[low]),
        high_.begin() + static_cast<std::ptrdiff_t>(offsets_[low + 1]));
    });
}

std::size_t EdgeTable::count(const Edge& edge) const
{
  const std::int64_t low = std::min(edge[0], edge[1]);
  const auto range = std::equal_range(high_.begin() + static_cast<std::ptrdiff_t>(offsets_[low]),
    high_.begin() + static_cast<std::ptrdiff_t>(offsets_[low + 1]), std::max(edge[0], edge[1]));
  return static_cast<std::size_t>(range.second - range.first);
}

} // namespace medial
