#include "sign/ambiguity.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdint>

namespace medial
{
namespace
{

/// Points along each axis: few where they leave no doubt.
constexpr int kFewPoints = 8;
constexpr int kManyPoints = 16;
/// Farther than this from 1/2, winding numbers tell inside from outside.
constexpr double kAmbiguous = 0.25;

/// Whether the winding number of an open surface is between 1/4 and 3/4.
/// @param closed winding number of the closed surface.
bool isAmbiguous(int closed, const WindingNumber& lids, const glm::dvec3& point)
{
  for (const double tolerance : { 1e-2, 1e-3, 1e-4, 0.0 })
  {
    const Interval w = lids.bounds(point, tolerance);
    const double low = closed - 0.5 - w.high;
    const double high = closed - 0.5 - w.low;
    if (low >= kAmbiguous || high <= -kAmbiguous)
    {
      return false;
    }
    if (low > -kAmbiguous && high < kAmbiguous)
    {
      return true;
    }
  }
  return false; // on the border
}

} // namespace

GridSample::GridSample(const GridFrame& whole, const Grid& grid, int maxPoints)
  : frame(whole)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    const int stride = (grid.dimensions[axis] + maxPoints - 1) / maxPoints;
    frame.first[axis] += 0.5 * (stride - 1) * whole.step[axis];
    frame.step[axis] *= stride;
    extent.max[axis] = std::max(1, grid.dimensions[axis] / stride) - 1;
  }
}

std::array<GridSample, 2> samplesOf(const GridFrame& frame, const Grid& grid)
{
  return { GridSample(frame, grid, kFewPoints), GridSample(frame, grid, kManyPoints) };
}

double ambiguousShareOf(const GridSample& sample, const std::vector<SliceCrossings>& closed,
  const WindingNumber& lids, const Checkpoint& checkpoint)
{
  std::atomic<std::int64_t> ambiguous{ 0 };
  tbb::parallel_for(0, sample.extent.size(2),
    [&](int k)
    {
      auto next = closed[k].begin();
      for (int j = 0; j < sample.extent.size(1); ++j)
      {
        checkpoint();
        int winding = 0;
        for (int i = 0; i < sample.extent.size(0); ++i)
        {
          for (; next != closed[k].end() && next->row == j && next->point <= i; ++next)
          {
            winding += next->change;
          }
          ambiguous += isAmbiguous(winding, lids, sample.frame.sample({ i, j, k })) ? 1 : 0;
        }
        for (; next != closed[k].end() && next->row == j; ++next)
        {
        }
      }
    });
  return static_cast<double>(ambiguous) / static_cast<double>(sample.extent.pointCount());
}

double ambiguousShare(const TriangleChain& closed, const WindingNumber& lids,
  const GridFrame& frame, const Grid& grid, const Checkpoint& checkpoint)
{
  double share = 0.0;
  for (const GridSample& sample : samplesOf(frame, grid))
  {
    share =
      ambiguousShareOf(sample, rowCrossings(closed, sample.frame, sample.extent), lids, checkpoint);
    if (share > kNoDoubt)
    {
      break;
    }
  }
  return share;
}

} // namespace medial
