#include "culling/closest_seeds.h"

namespace medial
{

void ClosestSeeds::reset(const Extent& extent)
{
  extent_ = extent;
  for (int axis = 0; axis < 3; ++axis)
  {
    counts_[axis] = (extent.size(axis) + kTileSize - 1) / kTileSize;
  }
  sites_.assign(static_cast<std::size_t>(counts_.x) * counts_.y * counts_.z, -1);
}

bool ClosestSeeds::knows(const Extent& extent) const
{
  return !sites_.empty() && extent_.min == extent.min && extent_.max == extent.max;
}

void ClosestSeeds::set(const Extent& tile, int site)
{
  sites_[this->indexOf(tile)] = site;
}

std::size_t ClosestSeeds::indexOf(const Extent& node) const
{
  std::size_t index = 0;
  for (int axis = 2; axis >= 0; --axis)
  {
    const int middle = node.min[axis] + (node.max[axis] - node.min[axis]) / 2;
    index = index * counts_[axis] + (middle - extent_.min[axis]) / kTileSize;
  }
  return index;
}

} // namespace medial
