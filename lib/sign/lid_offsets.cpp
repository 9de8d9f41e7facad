#include "sign/lid_offsets.h"

#include "base/longest_axis.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <optional>
#include <utility>

namespace medial
{
namespace
{

/// Boxes that the search starts with, points a side.
constexpr int kBlock = 32;
/// Boxes that are not divided any more have at most as many points.
constexpr int kPoints = Continuation::kPoints;
/// Boxes of at most as many points are tried as a whole.
constexpr int kTriedPoints = 8 * kPoints;
/// Largest error of a group of triangles or a triangle that counts as far from a ball of this
/// radius, in grid steps. Less is allowed in larger balls, since all balls inside inherit it.
constexpr double kTolerance = 1e-3;
constexpr double kToleratedRadius = 2.9;
/// Errors are made smaller by this factor, so many times, where points are uncertain.
constexpr double kRefinement = 10.0;
constexpr int kSteps = 6;
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

/// Values at the points of a small box.
using Integers = std::array<int, kPoints>;

/// Views of a ball, more and more exact, made when they are asked for.
class BallViews
{
public:
  /// @param outer views of a ball around this one; null for none.
  BallViews(const WindingNumber& lids, BallViews* outer, const glm::dvec3& centre, double radius,
    bool close)
    : lids_(lids)
    , outer_(outer)
    , centre_(centre)
    , radius_(radius)
    , close_(close)
  {
  }

  /// Returns the view after so many refinements.
  const WindingNumber::View& at(int step)
  {
    std::optional<WindingNumber::View>& view = views_[step];
    if (!view)
    {
      const double tolerance = kTolerance * std::pow(kRefinement, -step) /
        std::sqrt(std::max(1.0, radius_ / kToleratedRadius));
      view = outer_ != nullptr ? this->lookFrom(outer_->at(step), tolerance)
                               : this->lookFrom(lids_.everything(), tolerance);
    }
    return *view;
  }

  /// Returns the view in which all triangles are near.
  WindingNumber::View exact() const
  {
    return lids_.lookClosely(lids_.everything(), centre_, radius_, 0.0);
  }

private:
  WindingNumber::View lookFrom(const WindingNumber::View& outer, double tolerance) const
  {
    return close_ ? lids_.lookClosely(outer, centre_, radius_, tolerance)
                  : lids_.look(outer, centre_, radius_, tolerance);
  }

  const WindingNumber& lids_;
  BallViews* outer_;
  glm::dvec3 centre_;
  double radius_;
  bool close_;
  std::array<std::optional<WindingNumber::View>, kSteps> views_;
};

/// Grid points of a small box, and w rounded as far as it is known.
struct BoxPoints
{
  std::vector<glm::ivec3> indices;
  Integers k;
  std::vector<int> open; ///< whose k is unknown

  explicit BoxPoints(const Extent& box)
  {
    indices.reserve(kPoints);
    for (int z = box.min[2]; z <= box.max[2]; ++z)
    {
      for (int y = box.min[1]; y <= box.max[1]; ++y)
      {
        for (int x = box.min[0]; x <= box.max[0]; ++x)
        {
          indices.push_back({ x, y, z });
        }
      }
    }
    open.resize(indices.size());
    std::iota(open.begin(), open.end(), 0);
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

  void search(const Extent& box) { this->search(box, nullptr, nullptr); }

private:
  /// @param outer views of the box around this one; null for none.
  /// @param wide continuation of that box; null for none.
  void search(const Extent& box, BallViews* outer, const Continuation* wide)
  {
    checkpoint_();
    if (box.pointCount() <= kPoints)
    {
      this->searchPoints(box, outer, wide);
      return;
    }
    BallViews views = this->viewsOf(box, outer, false);
    if (this->addCertain(box, views.at(0)))
    {
      return;
    }
    std::optional<Continuation> continuation;
    if (box.pointCount() <= kTriedPoints)
    {
      continuation = lids_.continued(views.at(0));
    }
    const int longest = box.size(longestAxis(box));
    this->searchParts(box, longest, 0, views, continuation ? &*continuation : nullptr);
  }

  void searchPoints(const Extent& box, BallViews* outer, const Continuation* wide)
  {
    BoxPoints points(box);
    if (wide != nullptr)
    {
      this->roundBy(*wide, points);
    }
    if (!points.open.empty())
    {
      BallViews views = this->viewsOf(box, outer, true);
      if (this->addCertain(box, views.at(0)))
      {
        return;
      }
      this->roundBy(views, points);
    }
    this->addPoints(points);
  }

  BallViews viewsOf(const Extent& box, BallViews* outer, bool close) const
  {
    const glm::dvec3 low = this->sample(box.min);
    const glm::dvec3 high = this->sample(box.max);
    return { lids_, outer, 0.5 * (low + high), 0.5 * glm::distance(low, high), close };
  }

  /// Adds a box if one k is left.
  bool addCertain(const Extent& box, const WindingNumber::View& view)
  {
    const Interval w = lids_.bounds(view);
    const bool certain =
      std::floor(w.low + 0.5 - kRounding) == std::floor(w.high + 0.5 + kRounding);
    if (certain)
    {
      this->addBox(box, nearest(w.low));
    }
    return certain;
  }

  glm::dvec3 sample(const std::array<int, 3>& point) const
  {
    return frame_.sample({ point[0], point[1], point[2] });
  }

  /// Halves a box along its long axes.
  void searchParts(const Extent& box, int longest, int axis, BallViews& views,
    const Continuation* wide)
  {
    if (axis == 3)
    {
      this->search(box, &views, wide);
      return;
    }
    const int size = box.size(axis);
    if (2 * size <= longest)
    {
      this->searchParts(box, longest, axis + 1, views, wide);
      return;
    }
    Extent half = box;
    half.max[axis] = box.min[axis] + size / 2 - 1;
    this->searchParts(half, longest, axis + 1, views, wide);
    half.min[axis] = half.max[axis] + 1;
    half.max[axis] = box.max[axis];
    this->searchParts(half, longest, axis + 1, views, wide);
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

  void addPoints(const BoxPoints& points)
  {
    for (std::size_t i = 0; i < points.indices.size(); ++i)
    {
      if (points.k[i] != 0)
      {
        this->addPoint(points.indices[i], points.k[i]);
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

  /// Rounds w at open points. Errors are made smaller until only one integer is left; near a half
  /// all triangles are summed one by one.
  void roundBy(BallViews& views, BoxPoints& points) const
  {
    for (int step = 0; !points.open.empty() && step < kSteps; ++step)
    {
      const WindingNumber::View& view = views.at(step);
      if (const std::optional<Continuation> continuation = lids_.continued(view))
      {
        this->roundBy(*continuation, points);
      }
      this->sumUp(view, view.far.error + kRounding, points);
    }
    if (!points.open.empty())
    {
      this->sumUp(views.exact(), 0.0, points);
    }
  }

  /// Rounds w at open points where a continuation leaves no doubt.
  void roundBy(const Continuation& continuation, BoxPoints& points) const
  {
    Continuation::Points positions{};
    for (std::size_t i = 0; i < points.open.size(); ++i)
    {
      const glm::dvec3 position = frame_.sample(points.indices[points.open[i]]);
      positions.x[i] = position.x;
      positions.y[i] = position.y;
      positions.z[i] = position.z;
    }
    Continuation::Integers result;
    continuation.round(positions, kRounding, result);
    std::vector<int> left;
    for (std::size_t i = 0; i < points.open.size(); ++i)
    {
      if (result.certain[i] == 0.0)
      {
        left.push_back(points.open[i]);
        continue;
      }
      points.k[points.open[i]] = static_cast<int>(result.values[i]);
    }
    points.open = std::move(left);
  }

  /// Rounds w at open points where exact sums of the near triangles leave no doubt, eight points at
  /// once.
  void sumUp(const WindingNumber::View& view, double error, BoxPoints& points) const
  {
    std::vector<int> left;
    for (std::size_t begin = 0; begin < points.open.size(); begin += SolidAngleSums::kPoints)
    {
      const int* open = &points.open[begin];
      const int count = static_cast<int>(
        std::min<std::size_t>(SolidAngleSums::kPoints, points.open.size() - begin));
      SolidAngleSums::Points positions;
      for (int i = 0; i < SolidAngleSums::kPoints; ++i)
      {
        positions[i] = frame_.sample(points.indices[open[i < count ? i : 0]]);
      }
      const SolidAngleSums::Values w = lids_.at(view, positions);
      for (int i = 0; i < count; ++i)
      {
        points.k[open[i]] = nearest(w[i]);
        if (nearest(w[i] - error) != nearest(w[i] + error))
        {
          left.push_back(open[i]);
        }
      }
    }
    points.open = std::move(left);
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
    [&](std::size_t b) { OffsetSearch(lids, frame, checkpoint, found[b]).search(blocks[b]); });
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
