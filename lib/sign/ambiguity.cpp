#include "sign/ambiguity.h"

#include "sign/row_crossings.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdint>

namespace medial
{
namespace
{

constexpr int kMaxPoints = 16;
constexpr double kPrecision = 0.01;

/// Takes every n-th point of a grid, from the middle of the first n on.
struct Sample
{
  GridFrame frame;
  Extent extent;

  Sample(const GridFrame& whole, const Grid& grid)
    : frame(whole)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      const int stride = (grid.dimensions[axis] + kMaxPoints - 1) / kMaxPoints;
      frame.first[axis] += 0.5 * (stride - 1) * whole.step[axis];
      frame.step[axis] *= stride;
      extent.max[axis] = std::max(1, grid.dimensions[axis] / stride) - 1;
    }
  }
};

bool isAmbiguous(double winding)
{
  return std::abs(winding - 0.5) < 0.25;
}

} // namespace

double ambiguousShare(const TriangleChain& closed, const Lids& lids, const GridFrame& frame,
  const Grid& grid, const Checkpoint& checkpoint)
{
  const Sample sample(frame, grid);
  const std::vector<SliceCrossings> slices = rowCrossings(closed, sample.frame, sample.extent);
  std::atomic<std::int64_t> ambiguous{ 0 };
  tbb::parallel_for(0, sample.extent.size(2),
    [&](int k)
    {
      auto next = slices[k].begin();
      for (int j = 0; j < sample.extent.size(1); ++j)
      {
        checkpoint();
        int winding = 0;
        for (int i = 0; i < sample.extent.size(0); ++i)
        {
          for (; next != slices[k].end() && next->row == j && next->point <= i; ++next)
          {
            winding += next->change;
          }
          const double lid = lids.at(sample.frame.sample({ i, j, k }), kPrecision);
          ambiguous += isAmbiguous(winding - lid) ? 1 : 0;
        }
        for (; next != slices[k].end() && next->row == j; ++next)
        {
        }
      }
    });
  return static_cast<double>(ambiguous) / static_cast<double>(sample.extent.pointCount());
}

} // namespace medial
