#include "field/slab_culling.h"

#include "base/stopwatch.h"

#include <algorithm>
#include <cstdint>

namespace medial
{
namespace
{

CandidateHierarchy cullBlocks(const FieldJob& job, int slabSlices, TileHull hull,
  const ClosestSeeds& seeds)
{
  const Stopwatch watch(job.statistics.seconds.cull);
  const int leafSlices = std::min(slabSlices, CandidateHierarchy::kLeafSize);
  return job.run.onThreads([&]
    { return CandidateHierarchy(job.filter, job.frame, job.extent, hull, leafSlices, &seeds); });
}

} // namespace

SlabCulling::SlabCulling(const FieldJob& job, int slabSlices, TileHull hull,
  const ClosestSeeds& seeds)
  : job_(job)
  , hierarchy_(cullBlocks(job, slabSlices, hull, seeds))
{
  if (hull == TileHull::Cells)
  {
    query_ = std::make_unique<TileQuery>(job.sites, job.filter, job.frame, job.extent,
      hierarchy_.leafSize());
  }
}

std::vector<CandidateTiles> SlabCulling::tilesOf(const Extent& slab, const Checkpoint& checkpoint)
{
  const Stopwatch watch(job_.statistics.seconds.cull);
  std::vector<CandidateTiles> blocks =
    job_.run.onThreads([&] { return hierarchy_.leafTiles(slab, &checkpoint); });
  for (const CandidateTiles& block : blocks)
  {
    job_.statistics.candidatePairs += static_cast<std::int64_t>(block.candidates.size());
    if (query_)
    {
      query_->add(block);
    }
  }
  return blocks;
}

} // namespace medial
