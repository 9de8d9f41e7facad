#include "medial/reconstruction.h"

#include "balls/ball_union.h"
#include "base/extents.h"
#include "base/longest_axis.h"
#include "base/memory_guard.h"
#include "base/run.h"
#include "measure/reconstruction_field.h"
#include "medial/memory.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace medial
{
namespace
{

/// Number of points along an edge of the largest blocks.
constexpr int kBlockSize = 16;
/// Every point within this many voxels of the surface is computed on its own.
constexpr double kBand = 3.0;

double bandOf(const Grid& grid)
{
  return kBand * *std::max_element(grid.spacing.begin(), grid.spacing.end());
}

class FieldBuilder
{
public:
  FieldBuilder(const BallUnion& solid, const Grid& grid, const Extent& extent,
    std::vector<float>& field)
    : solid_(solid)
    , grid_(grid)
    , extent_(extent)
    , field_(field)
    , band_(bandOf(grid))
  {
  }

  /// Fills a block where the extent has points of it: at once if the surface is far away,
  /// otherwise part by part.
  /// @param limit at least the signed distance at the middle.
  void fill(const Extent& block, double limit)
  {
    if (commonPart(block, extent_).empty())
    {
      return;
    }
    const glm::dvec3 low = this->position(block.min);
    const glm::dvec3 high = this->position(block.max);
    const glm::dvec3 middle = 0.5 * (low + high);
    const double reach = 0.5 * glm::distance(low, high);
    const double distance = solid_.distance(middle, limit);
    if (block.pointCount() == 1 || std::abs(distance) > reach + band_)
    {
      // The distance changes by at most the way to the middle.
      this->set(block, static_cast<float>(distance - std::copysign(reach, distance)));
      return;
    }
    const int axis = longestAxis(block);
    Extent lower = block;
    Extent upper = block;
    lower.max[axis] = (block.min[axis] + block.max[axis]) / 2;
    upper.min[axis] = lower.max[axis] + 1;
    for (const Extent& part : { lower, upper })
    {
      const glm::dvec3 there = 0.5 * (this->position(part.min) + this->position(part.max));
      this->fill(part, distance + glm::distance(middle, there));
    }
  }

private:
  glm::dvec3 position(const std::array<int, 3>& point) const
  {
    const Point3 at = grid_.point(point[0], point[1], point[2]);
    return { at[0], at[1], at[2] };
  }

  void set(const Extent& block, float value)
  {
    const Extent part = commonPart(block, extent_);
    const auto width = static_cast<std::size_t>(extent_.size(0));
    const auto height = static_cast<std::size_t>(extent_.size(1));
    for (int z = part.min[2]; z <= part.max[2]; ++z)
    {
      for (int y = part.min[1]; y <= part.max[1]; ++y)
      {
        const std::size_t row =
          (static_cast<std::size_t>(z - extent_.min[2]) * height + (y - extent_.min[1])) * width;
        const auto first =
          field_.begin() + static_cast<std::ptrdiff_t>(row + (part.min[0] - extent_.min[0]));
        std::fill(first, first + part.size(0), value);
      }
    }
  }

  const BallUnion& solid_;
  const Grid& grid_;
  const Extent& extent_;
  std::vector<float>& field_;
  double band_;
};

} // namespace

Bounds modelBounds(const MedialModel& model)
{
  checkMedialModel(model);
  Bounds bounds = kEmptyBounds;
  for (std::size_t i = 0; i < model.centres.size(); ++i)
  {
    const auto& [x, y, z] = model.centres[i];
    const double r = model.radii[i];
    bounds = joined(bounds, { { x - r, y - r, z - r }, { x + r, y + r, z + r } });
  }
  return bounds;
}

std::vector<float> computeReconstruction(const MedialModel& model, const Grid& grid,
  const ReconstructionOptions& options)
{
  const Run run(options.execution);
  validateGrid(grid);
  requireMemory(grid.pointCount(), sizeof(float));
  return withMemoryErrors(grid.pointCount(),
    [&]
    {
      return reconstructionField(BallUnion(model, options.interpolate), grid, grid.wholeExtent(),
        run);
    });
}

Bounds reconstructionReach(const Grid& grid, const Extent& extent)
{
  const Extent blocks = wholeParts(extent, kBlockSize, grid.wholeExtent());
  // From the middle of a block to its corners, and a voxel for rounding.
  const double reach =
    0.5 * kBlockSize * std::hypot(grid.spacing[0], grid.spacing[1], grid.spacing[2]);
  const double margin = reach + bandOf(grid) * (1.0 + 1.0 / kBand);
  Bounds bounds{ grid.point(blocks.min[0], blocks.min[1], blocks.min[2]),
    grid.point(blocks.max[0], blocks.max[1], blocks.max[2]) };
  for (int axis = 0; axis < 3; ++axis)
  {
    bounds.min[axis] -= margin;
    bounds.max[axis] += margin;
  }
  return bounds;
}

std::vector<float> reconstructionField(const BallUnion& solid, const Grid& grid,
  const Extent& extent, const Run& run)
{
  std::vector<float> field(static_cast<std::size_t>(extent.pointCount()));
  if (extent.empty())
  {
    return field;
  }
  FieldBuilder builder(solid, grid, extent, field);
  // Blocks start where those of the whole grid do.
  const Extent all = wholeParts(extent, kBlockSize, grid.wholeExtent());
  Extent slab = all;
  for (; slab.min[2] <= all.max[2]; slab.min[2] += kBlockSize)
  {
    run.report(static_cast<double>(slab.min[2] - all.min[2]) / all.size(2),
      "distance to the balls");
    slab.max[2] = std::min(slab.min[2] + kBlockSize - 1, all.max[2]);
    std::vector<Extent> blocks;
    visitParts(slab, kBlockSize, [&blocks](const Extent& block) { blocks.push_back(block); });
    run.onThreads(
      [&]
      {
        tbb::parallel_for(std::size_t{ 0 }, blocks.size(),
          [&](std::size_t i) { builder.fill(blocks[i], std::numeric_limits<double>::infinity()); });
      });
  }
  return field;
}

} // namespace medial
