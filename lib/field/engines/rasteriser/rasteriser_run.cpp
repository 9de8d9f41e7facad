#include "field/engines/rasteriser/rasteriser_run.h"

#include "base/stopwatch.h"
#include "field/engines/rasteriser/hole_repair.h"
#include "field/slabs.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace medial
{

RasteriserRun::RasteriserRun(const FieldJob& job, Renderer& renderer, FieldSink& sink)
  : job_(job)
  , hierarchy_(job.host.filter(), job.frame, job.extent)
  , renderer_(renderer)
  , sink_(sink)
  , atlas_(renderer.object().atlas())
  , writer_(job, job.insideRows())
{
}

RasteriserRun::~RasteriserRun()
{
  if (rendering_.valid())
  {
    rendering_.wait();
  }
}

void RasteriserRun::compute(RasteriserSelection* selection)
{
  const std::vector<Extent> extents = slabsOf(job_.extent, atlas_.slabSlices);
  const double share = 1.0 / static_cast<double>(extents.size());
  firstArrays_ = sink_.slabArrays(extents[0]);
  this->allocateReadbacks(extents[0].size(2));
  for (std::size_t i = 0; i < extents.size(); ++i)
  {
    Slab& slab = ring_[i % 2];
    slab.previousSlices = i > 0 ? extents[i - 1].size(2) : 0;
    this->prepare(extents[i], static_cast<double>(i) * share, share, slab);
    this->finishRendering();
    rendering_ = renderer_.submit([this, &slab, selection](SlabRenderer& renderer)
      { this->render(renderer, slab, selection); });
    if (i > 0)
    {
      this->store(ring_[(i - 1) % 2]);
    }
  }
  this->finishRendering();
  this->store(ring_[(extents.size() - 1) % 2]);
  job_.statistics.seconds.draw += gpuSeconds_.draw;
  job_.statistics.seconds.resolve += gpuSeconds_.resolve;
  job_.statistics.seconds.medial += gpuSeconds_.medial;
  job_.statistics.fragments += fragments_;
}

void RasteriserRun::allocateReadbacks(int slices)
{
  const FieldArrays& wanted = firstArrays_;
  if (!wanted.any())
  {
    return;
  }
  const bool displacements = wanted.distance || wanted.closestPoint;
  const bool sites = wanted.closestSite || wanted.closestFeature || wanted.closestCell;
  for (Slab& slab : ring_)
  {
    slab.readback = std::make_unique<Readback>(atlas_, slices, displacements, sites);
  }
}

void RasteriserRun::prepare(const Extent& extent, double done, double share, Slab& slab)
{
  job_.run.report(done, "distance field");
  slab.extent = extent;
  slab.rectangles = this->gather(this->cull(extent, done), extent);
  job_.run.report(done + 0.5 * share, "distance field");
}

std::vector<CandidateTiles> RasteriserRun::cull(const Extent& extent, double done)
{
  const Checkpoint checkpoint(job_.run, done, "distance field");
  const Stopwatch watch(job_.statistics.seconds.cull);
  CullingCounts counts;
  std::vector<CandidateTiles> tiles =
    job_.run.onThreads([&] { return hierarchy_.listTiles(extent, counts, &checkpoint); });
  job_.statistics.groupTests += counts.groupTests;
  job_.statistics.siteTests += counts.siteTests;
  for (const CandidateTiles& some : tiles)
  {
    job_.statistics.candidatePairs += static_cast<std::int64_t>(some.candidates.size());
  }
  return tiles;
}

std::vector<SiteRectangle> RasteriserRun::gather(const std::vector<CandidateTiles>& tiles,
  const Extent& extent)
{
  const Stopwatch watch(job_.statistics.seconds.polygons);
  std::vector<SiteRectangle> rectangles =
    job_.run.onThreads([&] { return siteRectangles(tiles, extent, job_.host.sites().size()); });
  for (const SiteRectangle& rectangle : rectangles)
  {
    job_.statistics.polygons += rectangle.high.z - rectangle.low.z + 1;
  }
  return rectangles;
}

/// Runs on the GPU thread.
void RasteriserRun::render(SlabRenderer& renderer, Slab& slab, RasteriserSelection* selection)
{
  if (slab.previousSlices > 0)
  {
    renderer.carryLastSlice(slab.previousSlices);
  }
  timed(gpuSeconds_.draw, [&] { renderer.draw(slab.rectangles, slab.extent); });
  fragments_ += renderer.fragments();
  timed(gpuSeconds_.resolve,
    [&]
    {
      if (renderer.resolve(slab.extent) > 0)
      {
        this->repair(renderer, slab);
      }
    });
  if (selection != nullptr)
  {
    const Stopwatch watch(gpuSeconds_.medial);
    selection->process(renderer, slab.extent, slab.previousSlices > 0);
  }
  if (slab.readback)
  {
    const Stopwatch watch(gpuSeconds_.resolve);
    slab.readback->object().fetch(renderer, slab.extent.size(2));
  }
}

void RasteriserRun::repair(SlabRenderer& renderer, const Slab& slab) const
{
  repairHoles(renderer, job_.host.signNormals(), job_.frame, job_.host.query(), slab.extent);
}

void RasteriserRun::finishRendering()
{
  if (rendering_.valid())
  {
    rendering_.get();
  }
}

void RasteriserRun::store(const Slab& slab)
{
  const bool first = slab.extent.min[2] == job_.extent.min[2];
  const FieldArrays arrays = first ? firstArrays_ : sink_.slabArrays(slab.extent);
  if (slab.readback)
  {
    const Stopwatch watch(job_.statistics.seconds.resolve);
    const SlabReadback& readback = slab.readback->object();
    writer_.begin(slab.extent, arrays);
    job_.run.onThreads([&] { writer_.store(readback.values()); });
  }
  sink_.stored(slab.extent);
}

} // namespace medial
