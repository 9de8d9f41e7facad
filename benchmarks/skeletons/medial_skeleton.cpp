#include "skeletons/skeleton_method.h"

#include "medial/compute_medial_axis.h"
#include "medial/skeleton.h"
#include "medial/skeleton_resolution.h"

#include <utility>

namespace medial::benchmark
{
namespace
{

class MedialSkeleton final : public SkeletonMethod
{
public:
  explicit MedialSkeleton(std::optional<int> resolution)
    : resolution_(resolution)
  {
  }

  std::string name() const override
  {
    return "Medial, " + (resolution_ ? std::to_string(*resolution_) : std::string("auto"));
  }

  Network compute(const TriangleMesh& mesh) override
  {
    const MeshConnectivity connectivity = analyseConnectivity(mesh);
    SkeletonResolution chosen;
    if (!resolution_)
    {
      chosen = chooseSkeletonResolution(mesh, connectivity);
    }
    const int resolution = resolution_.value_or(chosen.resolution);
    MedialAxisOptions options;
    options.topology = Topology::Preserve;
    const Skeleton skeleton = chosen.skeleton
      ? std::move(*chosen.skeleton)
      : computeSkeleton(
          computeMedialAxis(mesh, connectivity, makeGrid(mesh.bounds(), resolution), options),
          mesh);
    const CellTopology topology = topologyOf(skeleton);
    Network network{ static_cast<std::int64_t>(skeleton.branches.size()), topology.genus,
      topology.components, 0.0, resolution };
    for (const SkeletonBranch& branch : skeleton.branches)
    {
      network.length += branch.length;
    }
    return network;
  }

private:
  std::optional<int> resolution_;
};

} // namespace

std::unique_ptr<SkeletonMethod> makeMedialSkeleton(std::optional<int> resolution)
{
  return std::make_unique<MedialSkeleton>(resolution);
}

} // namespace medial::benchmark
