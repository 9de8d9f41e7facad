#include "medial/skeleton_resolution.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace medial
{
namespace
{

/// Grid points in the radius of the thinnest branch.
constexpr double kPointsPerRadius = 4.0;
/// Grids that must be finer by more than this may show branches that are thinner still.
constexpr int kFiner = 4;

/// Passes on requests to stop, but no progress, since it is unknown how many grids will follow.
class Cancelling final : public Progress
{
public:
  explicit Cancelling(Progress* progress)
    : progress_(progress)
  {
  }

  void report(double, const char*) override
  {
    if (progress_ != nullptr)
    {
      progress_->report(0.0, "resolution");
    }
  }
  bool cancelled() override { return progress_ != nullptr && progress_->cancelled(); }

private:
  Progress* progress_;
};

int resolutionFor(double radius, const Bounds& bounds, double padding)
{
  const double length = makeGrid(bounds, 2, padding).spacing[0];
  const double points = std::ceil(length * kPointsPerRadius / radius) + 1.0;
  return points < kMaxDimension ? std::max(kMinResolution, static_cast<int>(points))
                                : kMaxDimension;
}

} // namespace

int neededResolution(const Skeleton& skeleton, const Bounds& bounds, double padding)
{
  return resolutionFor(thinnestRadius(skeleton), bounds, padding);
}

SkeletonResolution chooseSkeletonResolution(const TriangleMesh& mesh,
  const MeshConnectivity& connectivity, const MedialAxisOptions& axisOptions,
  const SkeletonOptions& skeletonOptions, double padding)
{
  Cancelling axisProgress(axisOptions.field.execution.progress);
  Cancelling skeletonProgress(skeletonOptions.execution.progress);
  MedialAxisOptions ofAxis = axisOptions;
  ofAxis.topology = Topology::Preserve;
  ofAxis.field.execution.progress = &axisProgress;
  SkeletonOptions ofSkeleton = skeletonOptions;
  ofSkeleton.execution.progress = &skeletonProgress;
  const Bounds bounds = mesh.bounds();
  SkeletonResolution result;
  for (int tried = kMinSkeletonResolution; tried < kMaxSkeletonResolution; tried *= 2)
  {
    const Grid grid = makeGrid(bounds, tried, padding);
    MedialAxis axis = computeMedialAxis(mesh, connectivity, grid, ofAxis);
    if (axis.cellCount() == 0 && axis.sign != SignMethod::None)
    {
      result.thinnestRadius = std::numeric_limits<double>::infinity();
      result.needed = kMaxSkeletonResolution;
      continue;
    }
    Skeleton skeleton = computeSkeleton(axis, mesh, ofSkeleton);
    result.thinnestRadius = thinnestRadius(skeleton);
    result.needed = resolutionFor(result.thinnestRadius, bounds, padding);
    if (std::max(result.needed, kMinSkeletonResolution) == tried)
    {
      result.skeleton = std::move(skeleton);
      result.axis = std::move(axis);
    }
    if (result.needed <= kFiner * tried)
    {
      break;
    }
  }
  result.resolution = std::clamp(result.needed, kMinSkeletonResolution, kMaxSkeletonResolution);
  return result;
}

} // namespace medial
