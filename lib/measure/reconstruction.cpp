#include "medial/reconstruction.h"

#include "balls/ball_union.h"
#include "base/longest_axis.h"
#include "base/memory_guard.h"
#include "base/run.h"
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

class FieldBuilder
{
public:
  FieldBuilder(const BallUnion& solid, const Grid& grid, std::vector<float>& field)
    : solid_(solid)
    , grid_(grid)
    , field_(field)
    , band_(kBand * *std::max_element(grid.spacing.begin(), grid.spacing.end()))
  {
  }

  /// Fills a block: at once if the surface is far away, otherwise part by part.
  /// @param limit at least the signed distance at the middle.
  void fill(const Extent& block, double limit)
  {
    const glm::dvec3 low = this->position(block.min);
    const glm::dvec3 high = this->position(block.max);
    const glm::dvec3 middle = 0.5 * (low + high);
    const double reach = 0.5 * glm::distance(low, high);
    const double distance = solid_.nearest(middle, limit).distance;
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
    const auto width = static_cast<std::size_t>(grid_.dimensions[0]);
    const auto height = static_cast<std::size_t>(grid_.dimensions[1]);
    for (int z = block.min[2]; z <= block.max[2]; ++z)
    {
      for (int y = block.min[1]; y <= block.max[1]; ++y)
      {
        const auto row = field_.begin() +
          static_cast<std::ptrdiff_t>((static_cast<std::size_t>(z) * height + y) * width);
        std::fill(row + block.min[0], row + block.max[0] + 1, value);
      }
    }
  }

  const BallUnion& solid_;
  const Grid& grid_;
  std::vector<float>& field_;
  double band_;
};

std::vector<Extent> blocksOf(const Extent& slab)
{
  std::vector<Extent> blocks;
  for (int y = slab.min[1]; y <= slab.max[1]; y += kBlockSize)
  {
    for (int x = slab.min[0]; x <= slab.max[0]; x += kBlockSize)
    {
      blocks.push_back({ { x, y, slab.min[2] },
        { std::min(x + kBlockSize - 1, slab.max[0]), std::min(y + kBlockSize - 1, slab.max[1]),
          slab.max[2] } });
    }
  }
  return blocks;
}

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
      const BallUnion solid(model, options.interpolate);
      std::vector<float> field(static_cast<std::size_t>(grid.pointCount()));
      FieldBuilder builder(solid, grid, field);
      Extent slab = grid.wholeExtent();
      const int last = slab.max[2];
      for (; slab.min[2] <= last; slab.min[2] += kBlockSize)
      {
        run.report(static_cast<double>(slab.min[2]) / (last + 1), "distance to the balls");
        slab.max[2] = std::min(slab.min[2] + kBlockSize - 1, last);
        const std::vector<Extent> blocks = blocksOf(slab);
        run.onThreads(
          [&]
          {
            tbb::parallel_for(std::size_t{ 0 }, blocks.size(),
              [&](std::size_t i)
              { builder.fill(blocks[i], std::numeric_limits<double>::infinity()); });
          });
      }
      return field;
    });
}

} // namespace medial
