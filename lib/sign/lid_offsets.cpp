#include "sign/lid_offsets.h"

#include "base/longest_axis.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <tuple>

namespace medial
{
namespace
{

/// Boxes that the search starts with, points a side.
constexpr int kBlock = 16;

int nearest(double value)
{
  return static_cast<int>(std::floor(value + 0.5));
}

/// A row of a box of grid points, with k at its first point.
struct OffsetRow
{
  glm::ivec3 first;
  int end; ///< index along x after the last point
  int k;
  bool crossed; ///< whether lids pass through the row, so that k changes with W
};

/// Finds the rows in which k is not 0 for all points.
class OffsetSearch
{
public:
  OffsetSearch(const Lids& lids, const GridFrame& frame, std::vector<OffsetRow>& found)
    : lids_(lids)
    , frame_(frame)
    , found_(found)
  {
  }

  void search(const Extent& box, const Lids::View& outer)
  {
    const glm::dvec3 low = this->sample({ box.min[0], box.min[1], box.min[2] });
    const glm::dvec3 high = this->sample({ box.max[0], box.max[1], box.max[2] });
    const Lids::View view = lids_.look(outer, 0.5 * (low + high), 0.5 * glm::distance(low, high));
    if (box.pointCount() == 1)
    {
      this->addBox(box, lids_.rounded(view, low));
      return;
    }
    const Interval w = lids_.smoothBounds(view);
    if (std::floor(w.low + 0.5) == std::floor(w.high + 0.5))
    {
      if (lids_.mayMeet(view))
      {
        this->addCrossed(box, view, 0.5 * (w.low + w.high));
      }
      else
      {
        this->addBox(box, nearest(w.low));
      }
      return;
    }
    const int axis = longestAxis(box);
    Extent half = box;
    half.max[axis] = box.min[axis] + box.size(axis) / 2 - 1;
    this->search(half, view);
    half.min[axis] = half.max[axis] + 1;
    half.max[axis] = box.max[axis];
    this->search(half, view);
  }

private:
  glm::dvec3 sample(const glm::ivec3& point) const { return frame_.sample(point); }

  void addBox(const Extent& box, int k)
  {
    for (int z = box.min[2]; k != 0 && z <= box.max[2]; ++z)
    {
      for (int y = box.min[1]; y <= box.max[1]; ++y)
      {
        found_.push_back({ { box.min[0], y, z }, box.max[0] + 1, k, false });
      }
    }
  }

  /// Adds the rows of a box through which lids pass.
  /// @param smooth middle of the values of w in the box, but for its jumps.
  void addCrossed(const Extent& box, const Lids::View& view, double smooth)
  {
    for (int z = box.min[2]; z <= box.max[2]; ++z)
    {
      for (int y = box.min[1]; y <= box.max[1]; ++y)
      {
        const glm::ivec3 first(box.min[0], y, z);
        const int jump = nearest(lids_.roughly(view, this->sample(first)) - smooth);
        found_.push_back({ first, box.max[0] + 1, nearest(smooth) + jump, true });
      }
    }
  }

  const Lids& lids_;
  GridFrame frame_;
  std::vector<OffsetRow>& found_;
};

std::vector<Extent> blocksOf(const Extent& extent)
{
  std::vector<Extent> blocks;
  Extent block;
  for (int k = extent.min[2]; k <= extent.max[2]; k += kBlock)
  {
    for (int j = extent.min[1]; j <= extent.max[1]; j += kBlock)
    {
      for (int i = extent.min[0]; i <= extent.max[0]; i += kBlock)
      {
        block.min = { i, j, k };
        for (int axis = 0; axis < 3; ++axis)
        {
          block.max[axis] = std::min(block.min[axis] + kBlock - 1, extent.max[axis]);
        }
        blocks.push_back(block);
      }
    }
  }
  return blocks;
}

/// Adds the changes of -k along a row.
/// @param lids where rows of the slice pass through lids.
void addChanges(const OffsetRow& row, const SliceCrossings& lids, SliceCrossings& slice)
{
  const int y = row.first.y;
  int k = row.k;
  slice.push_back({ y, row.first.x, -k });
  if (row.crossed)
  {
    auto crossing = std::upper_bound(lids.begin(), lids.end(), RowCrossing{ y, row.first.x, 0 },
      [](const RowCrossing& a, const RowCrossing& b)
      { return std::tie(a.row, a.point) < std::tie(b.row, b.point); });
    for (; crossing != lids.end() && crossing->row == y && crossing->point < row.end; ++crossing)
    {
      slice.push_back({ y, crossing->point, -crossing->change });
      k += crossing->change;
    }
  }
  slice.push_back({ y, row.end, k });
}

TriangleChain lidsOnly(const ClosedSurface& surface)
{
  TriangleChain lids{ surface.chain.points, {} };
  lids.triangles.assign(surface.chain.triangles.begin() +
      static_cast<std::ptrdiff_t>(surface.lidOffsets.front()),
    surface.chain.triangles.end());
  return lids;
}

} // namespace

void subtractLids(const ClosedSurface& surface, const Lids& lids, const GridFrame& frame,
  const Extent& extent, const Checkpoint& checkpoint, std::vector<SliceCrossings>& slices)
{
  const std::vector<SliceCrossings> crossings = rowCrossings(lidsOnly(surface), frame, extent);
  const std::vector<Extent> blocks = blocksOf(extent);
  const Lids::View everything = lids.everything();
  std::vector<std::vector<OffsetRow>> found(blocks.size());
  tbb::parallel_for(std::size_t{ 0 }, blocks.size(),
    [&](std::size_t b)
    {
      checkpoint();
      OffsetSearch(lids, frame, found[b]).search(blocks[b], everything);
    });
  for (const std::vector<OffsetRow>& rows : found)
  {
    for (const OffsetRow& row : rows)
    {
      const int slice = row.first.z - extent.min[2];
      addChanges(row, crossings[slice], slices[slice]);
    }
  }
  tbb::parallel_for(std::size_t{ 0 }, slices.size(),
    [&](std::size_t k) { sortCrossings(slices[k]); });
}

} // namespace medial
