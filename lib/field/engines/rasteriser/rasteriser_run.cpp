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
    slab.extent = extents[i];
    job_.run.report(static_cast<double>(i) * share, "distance field");
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
  job_.statistics.seconds.cull += gpuSeconds_.cull;
  job_.statistics.seconds.polygons += counts_.seconds;
  job_.statistics.seconds.draw += gpuSeconds_.draw - counts_.seconds;
  job_.statistics.seconds.resolve += gpuSeconds_.resolve;
  job_.statistics.seconds.medial += gpuSeconds_.medial;
  job_.statistics.fragments += fragments_;
  job_.statistics.groupTests += counts_.tests;
  job_.statistics.candidatePairs += counts_.pairs;
  job_.statistics.polygons += counts_.polygons;
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

/// Runs on the GPU thread.
void RasteriserRun::render(SlabRenderer& renderer, Slab& slab, RasteriserSelection* selection)
{
  if (slab.previousSlices > 0)
  {
    renderer.carryLastSlice(slab.previousSlices);
  }
  timed(gpuSeconds_.cull, [&] { renderer.cull(slab.extent); });
  timed(gpuSeconds_.draw, [&] { renderer.draw(renderer.rectangles(), slab.extent); });
  fragments_ += renderer.fragments();
  counts_ += renderer.rectangles().counts();
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
