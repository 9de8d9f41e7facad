#include "field/slab_culling.h"

#include "base/stopwatch.h"

#include <cstdint>

namespace medial
{
namespace
{

CandidateHierarchy cullBlocks(const FieldJob& job, TileHull hull, const ClosestSeeds& seeds)
{
  const Stopwatch watch(job.statistics.seconds.cull);
  return job.run.onThreads(
    [&] { return CandidateHierarchy(job.filter, job.frame, job.extent, hull, &seeds); });
}

} // namespace

SlabCulling::SlabCulling(const FieldJob& job, TileHull hull, const ClosestSeeds& seeds)
  : job_(job)
  , hierarchy_(cullBlocks(job, hull, seeds))
{
  if (hull == TileHull::Cells)
  {
    query_ = std::make_unique<TileQuery>(job.sites, job.filter, job.frame, job.extent);
  }
}

std::shared_ptr<const SlabCulling::Tiles> SlabCulling::tilesOf(const Extent& slab,
  const Checkpoint& checkpoint)
{
  const Extent layers = hierarchy_.layersOf(slab);
  if (tiles_ != nullptr && layers.min == layers_.min && layers.max == layers_.max)
  {
    return tiles_;
  }
  const Stopwatch watch(job_.statistics.seconds.cull);
  tiles_.reset();
  tiles_ = std::make_shared<const Tiles>(
    job_.run.onThreads([&] { return hierarchy_.leafTiles(layers, &checkpoint); }));
  layers_ = layers;
  for (const CandidateTiles& block : *tiles_)
  {
    job_.statistics.candidatePairs += static_cast<std::int64_t>(block.candidates.size());
    if (query_)
    {
      query_->add(block);
    }
  }
  return tiles_;
}

} // namespace medial
