#include "sign/row_crossings.h"

#include "sign/line_crossing.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <tuple>

namespace medial
{
namespace
{

/// Number of slices that one task cuts.
constexpr int kBlock = 4;

struct IndexRange
{
  int first;
  int last;
};

/// Returns the indices of planes between two coordinates, and one more on either side against
/// rounding, as far as they are in [min, max].
IndexRange planesBetween(double low, double high, double origin, double step, int min, int max)
{
  const auto index = [&](double coordinate)
  { return std::clamp((coordinate - origin) / step, min - 2.0, max + 2.0); };
  return { std::max(min, static_cast<int>(std::floor(index(low)))),
    std::min(max, static_cast<int>(std::ceil(index(high)))) };
}

class SliceCutter
{
public:
  SliceCutter(const TriangleChain& surface, const GridFrame& frame, const Extent& extent)
    : surface_(surface)
    , frame_(frame)
    , extent_(extent)
    , slices_(extent.size(2))
    , blocks_((extent.size(2) + kBlock - 1) / kBlock)
  {
    for (std::size_t t = 0; t < surface.triangles.size(); ++t)
    {
      const IndexRange slices = this->slicesOf(surface.cornersOf(surface.triangles[t]));
      for (int block = (slices.first - extent.min[2]) / kBlock;
           slices.first <= slices.last && block <= (slices.last - extent.min[2]) / kBlock; ++block)
      {
        blocks_[block].push_back(static_cast<int>(t));
      }
    }
    tbb::parallel_for(std::size_t{ 0 }, blocks_.size(),
      [this](std::size_t block) { this->cut(static_cast<int>(block)); });
  }

  std::vector<SliceCrossings> take() { return std::move(slices_); }

private:
  IndexRange slicesOf(const std::array<glm::dvec3, 3>& corners) const
  {
    const auto [low, high] = std::minmax({ corners[0].z, corners[1].z, corners[2].z });
    return planesBetween(low, high, frame_.first.z, frame_.step.z, extent_.min[2], extent_.max[2]);
  }

  void cut(int block)
  {
    const int first = extent_.min[2] + block * kBlock;
    const int last = std::min(first + kBlock - 1, extent_.max[2]);
    for (const int t : blocks_[block])
    {
      const WeightedTriangle& triangle = surface_.triangles[t];
      const std::array<glm::dvec3, 3> corners = surface_.cornersOf(triangle);
      const IndexRange slices = this->slicesOf(corners);
      for (int k = std::max(first, slices.first); k <= std::min(last, slices.last); ++k)
      {
        addCrossings(corners, triangle.weight, frame_, extent_, k, slices_[k - extent_.min[2]]);
      }
    }
    for (int k = first; k <= last; ++k)
    {
      sortCrossings(slices_[k - extent_.min[2]]);
    }
    blocks_[block] = {};
  }

  const TriangleChain& surface_;
  GridFrame frame_;
  Extent extent_;
  std::vector<SliceCrossings> slices_;
  std::vector<std::vector<int>> blocks_; ///< triangles of every block of slices
};

} // namespace

void addCrossings(const std::array<glm::dvec3, 3>& corners, int weight, const GridFrame& frame,
  const Extent& extent, int slice, SliceCrossings& crossings)
{
  const auto segment = cutAt(corners, frame.first.z + slice * frame.step.z);
  if (!segment)
  {
    return;
  }
  const auto [low, high] = std::minmax(segment->from.y, segment->to.y);
  const IndexRange rows =
    planesBetween(low, high, frame.first.y, frame.step.y, extent.min[1], extent.max[1]);
  for (int j = rows.first; j <= rows.last; ++j)
  {
    if (const auto crossing = crossLine(*segment, frame.first.y + j * frame.step.y))
    {
      const double index = (crossing->x - frame.first.x) / frame.step.x;
      if (index < extent.max[0])
      {
        const double beyond = std::max<double>(extent.min[0], std::floor(index) + 1.0);
        crossings.push_back({ j, static_cast<int>(beyond), crossing->direction * weight });
      }
    }
  }
}

void sortCrossings(SliceCrossings& crossings)
{
  std::sort(crossings.begin(), crossings.end(),
    [](const RowCrossing& a, const RowCrossing& b)
    { return std::tie(a.row, a.point) < std::tie(b.row, b.point); });
}

std::vector<SliceCrossings> rowCrossings(const TriangleChain& surface, const GridFrame& frame,
  const Extent& extent)
{
  return SliceCutter(surface, frame, extent).take();
}

} // namespace medial
