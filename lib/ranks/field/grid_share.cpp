#include "ranks/field/grid_share.h"

#include "base/extents.h"
#include "field/slabs.h"
#include "medial/error.h"

#include <algorithm>
#include <string>
#include <utility>

namespace medial
{

GridShare::GridShare(const Grid& grid, std::vector<Extent> extents, int rank)
  : whole_(grid.wholeExtent())
  , extents_(std::move(extents))
  , rank_(rank)
{
  std::int64_t points = 0;
  for (std::size_t i = 0; i < extents_.size(); ++i)
  {
    if (extents_[i].empty())
    {
      continue;
    }
    points += extents_[i].pointCount();
    for (std::size_t j = 0; j < i; ++j)
    {
      if (meet(extents_[i], extents_[j]))
      {
        throw Error(ErrorCode::InvalidInput,
          "the extents of ranks " + std::to_string(j) + " and " + std::to_string(i) + " overlap");
      }
    }
    if (!whole_.contains(extents_[i]))
    {
      throw Error(ErrorCode::InvalidInput,
        "the extent of rank " + std::to_string(i) + " leaves the grid");
    }
  }
  if (points != grid.pointCount())
  {
    throw Error(ErrorCode::InvalidInput,
      "the extents of the ranks have " + std::to_string(points) + " of the grid's " +
        std::to_string(grid.pointCount()) + " points");
  }
}

int GridShare::ownerOf(const glm::ivec3& cell) const
{
  const glm::ivec3 point = this->nearest(cell);
  return static_cast<int>(
    std::find_if(extents_.begin(), extents_.end(),
      [&](const Extent& extent) { return !extent.empty() && hasPoint(extent, point); }) -
    extents_.begin());
}

Extent GridShare::withHalo(int rank, int halo) const
{
  return grown(extents_[rank], halo, whole_);
}

bool GridShare::meet(const Extent& a, const Extent& b)
{
  return !a.empty() && !b.empty() && !commonPart(a, b).empty();
}

glm::ivec3 GridShare::nearest(const glm::ivec3& cell) const
{
  const glm::ivec3 low(whole_.min[0], whole_.min[1], whole_.min[2]);
  const glm::ivec3 high(whole_.max[0], whole_.max[1], whole_.max[2]);
  return glm::clamp(cell, low, high);
}

AxisOrder::AxisOrder(const Grid& grid)
  : size_(grid.dimensions[0], grid.dimensions[1], grid.dimensions[2])
{
}

std::int64_t AxisOrder::ofCrossing(const Crossing& crossing) const
{
  const glm::ivec3& voxel = crossing.voxel;
  // Edges from the last slice of the thickest slabs to the next slab come after those in it.
  const bool late = crossing.axis == 2 && (voxel.z + 1) % kMaxSlices == 0;
  const std::int64_t row = (std::int64_t{ 2 } * voxel.z + (late ? 1 : 0)) * size_.y + voxel.y;
  return (row * 3 + crossing.axis) * size_.x + voxel.x;
}

std::int64_t AxisOrder::ofVertex(const glm::ivec3& cell, bool inside) const
{
  // The first cells lie before the grid.
  const std::int64_t row = std::int64_t{ cell.z + 1 } * (size_.y + 1) + cell.y + 1;
  return row * (2 * (size_.x + 1)) + 2 * (cell.x + 1) + (inside ? 1 : 0);
}

std::int64_t AxisOrder::span() const
{
  return std::int64_t{ 6 } * (size_.x + 1) * (size_.y + 1) * (size_.z + 1);
}

} // namespace medial
