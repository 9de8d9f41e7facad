#include "sign/lid_offsets.h"

#include "base/longest_axis.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace medial
{
namespace
{

/// Boxes that the search starts with, points a side.
constexpr int kBlock = 32;
/// Largest error of a group of triangles or a triangle that counts as far.
constexpr double kTolerance = 1e-3;
/// Errors are made smaller by this factor, down to this one, where points are uncertain.
constexpr double kRefinement = 4.0;
constexpr double kMinTolerance = 1e-7;
/// Rounding of a sum.
constexpr double kRounding = 1e-9;

int nearest(double value)
{
  return static_cast<int>(std::floor(value + 0.5));
}

/// Points of a row that follow each other and have the same k, which is not 0.
struct OffsetRun
{
  glm::ivec3 first;
  int end; ///< index along x after the last point
  int k;
};

using Indices = std::array<glm::ivec3, SolidAngleSums::kPoints>;
using Numbers = std::array<int, SolidAngleSums::kPoints>;

/// Values as the nearest integers, halves upwards.
struct Rounding
{
  Numbers values;
  bool certain = true; ///< whether the error does not matter

  Rounding(const SolidAngleSums::Values& exact, double error)
  {
    for (int i = 0; i < SolidAngleSums::kPoints; ++i)
    {
      values[i] = nearest(exact[i]);
      certain = certain && nearest(exact[i] - error - kRounding) == values[i] &&
        nearest(exact[i] + error + kRounding) == values[i];
    }
  }
};

/// Finds the runs of grid points at which k is not 0.
class OffsetSearch
{
public:
  OffsetSearch(const WindingNumber& lids, const GridFrame& frame, const Checkpoint& checkpoint,
    std::vector<OffsetRun>& found)
    : lids_(lids)
    , frame_(frame)
    , checkpoint_(checkpoint)
    , found_(found)
  {
  }

  void search(const Extent& box, const WindingNumber::View& outer)
  {
    checkpoint_();
    const glm::dvec3 low = this->sample(box.min);
    const glm::dvec3 high = this->sample(box.max);
    const glm::dvec3 centre = 0.5 * (low + high);
    const double radius = 0.5 * glm::distance(low, high);
    if (box.pointCount() <= SolidAngleSums::kPoints)
    {
      this->addPoints(box, lids_.lookClosely(outer, centre, radius, kTolerance));
      return;
    }
    const WindingNumber::View view = lids_.look(outer, centre, radius, kTolerance);
    const Interval w = lids_.bounds(view);
    if (std::floor(w.low + 0.5 - kRounding) == std::floor(w.high + 0.5 + kRounding))
    {
      this->addBox(box, nearest(w.low));
      return;
    }
    const int longest = box.size(longestAxis(box));
    this->searchParts(box, longest, 0, view);
  }

private:
  glm::dvec3 sample(const std::array<int, 3>& point) const
  {
    return frame_.sample({ point[0], point[1], point[2] });
  }

  /// Halves a box along its long axes.
  void searchParts(const Extent& box, int longest, int axis, const WindingNumber::View& view)
  {
    if (axis == 3)
    {
      this->search(box, view);
      return;
    }
    const int size = box.size(axis);
    if (2 * size <= longest)
    {
      this->searchParts(box, longest, axis + 1, view);
      return;
    }
    Extent half = box;
    half.max[axis] = box.min[axis] + size / 2 - 1;
    this->searchParts(half, longest, axis + 1, view);
    half.min[axis] = half.max[axis] + 1;
    half.max[axis] = box.max[axis];
    this->searchParts(half, longest, axis + 1, view);
  }

  void addBox(const Extent& box, int k)
  {
    for (int z = box.min[2]; k != 0 && z <= box.max[2]; ++z)
    {
      for (int y = box.min[1]; y <= box.max[1]; ++y)
      {
        found_.push_back({ { box.min[0], y, z }, box.max[0] + 1, k });
      }
    }
  }

  /// Looks at the points of a box singly.
  /// @param view close view of the box.
  void addPoints(const Extent& box, const WindingNumber::View& view)
  {
    Indices indices;
    int count = 0;
    for (int z = box.min[2]; z <= box.max[2]; ++z)
    {
      for (int y = box.min[1]; y <= box.max[1]; ++y)
      {
        for (int x = box.min[0]; x <= box.max[0]; ++x)
        {
          indices[count++] = { x, y, z };
        }
      }
    }
    std::fill(indices.begin() + count, indices.end(), indices.front());
    const Numbers k = this->rounded(view, indices);
    for (int i = 0; i < count; ++i)
    {
      if (k[i] != 0)
      {
        this->addPoint(indices[i], k[i]);
      }
    }
  }

  /// Prolongs the last run if that ends here.
  void addPoint(const glm::ivec3& index, int k)
  {
    if (!found_.empty() && found_.back().end == index.x && found_.back().k == k &&
      found_.back().first.y == index.y && found_.back().first.z == index.z)
    {
      ++found_.back().end;
      return;
    }
    found_.push_back({ index, index.x + 1, k });
  }

  /// Returns w at grid points in the ball of a close view, rounded. Bounds are refined until only
  /// one integer is left; near a half all triangles are summed one by one.
  Numbers rounded(WindingNumber::View view, const Indices& indices) const
  {
    SolidAngleSums::Points points;
    std::transform(indices.begin(), indices.end(), points.begin(),
      [this](const glm::ivec3& index) { return frame_.sample(index); });
    for (double tolerance = kTolerance / kRefinement;; tolerance /= kRefinement)
    {
      const Rounding rounding(lids_.at(view, points), view.far.error);
      if (rounding.certain || tolerance < kMinTolerance / kRefinement)
      {
        return rounding.values;
      }
      view = lids_.lookClosely(lids_.everything(), view.far.centre, view.far.radius,
        tolerance < kMinTolerance ? 0.0 : tolerance);
    }
  }

  const WindingNumber& lids_;
  GridFrame frame_;
  const Checkpoint& checkpoint_;
  std::vector<OffsetRun>& found_;
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

} // namespace

void subtractLids(const WindingNumber& lids, const GridFrame& frame, const Extent& extent,
  const Checkpoint& checkpoint, std::vector<SliceCrossings>& slices)
{
  const std::vector<Extent> blocks = blocksOf(extent);
  std::vector<std::vector<OffsetRun>> found(blocks.size());
  tbb::parallel_for(std::size_t{ 0 }, blocks.size(),
    [&](std::size_t b)
    { OffsetSearch(lids, frame, checkpoint, found[b]).search(blocks[b], lids.everything()); });
  for (const std::vector<OffsetRun>& runs : found)
  {
    for (const OffsetRun& run : runs)
    {
      SliceCrossings& slice = slices[run.first.z - extent.min[2]];
      slice.push_back({ run.first.y, run.first.x, -run.k });
      slice.push_back({ run.first.y, run.end, run.k });
    }
  }
  tbb::parallel_for(std::size_t{ 0 }, slices.size(),
    [&](std::size_t k) { sortCrossings(slices[k]); });
}

} // namespace medial
