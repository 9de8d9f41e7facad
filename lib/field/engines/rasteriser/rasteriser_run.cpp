#include "field/engines/rasteriser/rasteriser_run.h"

#include "base/stopwatch.h"
#include "culling/tile_query.h"
#include "field/engines/rasteriser/hole_repair.h"
#include "field/slabs.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace medial
{

RasteriserRun::RasteriserRun(const FieldJob& job, SlabCulling& culling, Renderer& renderer,
  FieldSink& sink)
  : job_(job)
  , culling_(culling)
  , renderer_(renderer)
  , sink_(sink)
  , atlas_(renderer.object().atlas())
  , writer_(job)
{
  seeds_.reset(job.extent);
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
  slab.tiles = culling_.tilesOf(extent, Checkpoint(job_.run, done, "distance field"));
  this->clip(slab);
  job_.run.report(done + 0.5 * share, "distance field");
}

void RasteriserRun::clip(Slab& slab)
{
  RunStatistics& statistics = job_.statistics;
  const Stopwatch watch(statistics.seconds.polygons);
  slab.chunks = job_.run.onThreads(
    [&] { return buildPolygons(job_.sites, job_.frame, *slab.tiles, slab.extent, atlas_); });
  double area = 0.0;
  for (const PolygonChunk& chunk : slab.chunks)
  {
    statistics.polygons += chunk.polygons;
    area += chunk.area;
  }
  statistics.fragments += static_cast<std::int64_t>(area);
}

/// Runs on the GPU thread.
void RasteriserRun::render(SlabRenderer& renderer, Slab& slab, RasteriserSelection* selection)
{
  if (slab.previousSlices > 0)
  {
    renderer.carryLastSlice(slab.previousSlices);
  }
  timed(gpuSeconds_.draw, [&] { renderer.draw(slab.chunks); });
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
  TileQuery query(job_.sites, job_.filter, job_.frame, culling_.hierarchy().layersOf(slab.extent));
  for (const CandidateTiles& block : *slab.tiles)
  {
    query.add(block);
  }
  repairHoles(renderer, job_.normals, job_.frame, query, job_.sign, slab.extent);
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
    job_.run.onThreads([&] { writer_.store(readback.displacements(), readback.sites()); });
    this->noteSeeds(slab);
  }
  sink_.stored(slab.extent);
}

void RasteriserRun::noteSeeds(const Slab& slab)
{
  const std::int32_t* sites = slab.readback->object().sites();
  if (sites == nullptr)
  {
    return;
  }
  for (const CandidateTiles& block : *slab.tiles)
  {
    for (const Extent& tile : block.tiles)
    {
      const int middleSlice = tile.min[2] + (tile.max[2] - tile.min[2]) / 2;
      if (middleSlice < slab.extent.min[2] || middleSlice > slab.extent.max[2])
      {
        continue;
      }
      std::size_t index = 0;
      for (int axis = 2; axis >= 0; --axis)
      {
        const int middle = tile.min[axis] + (tile.max[axis] - tile.min[axis]) / 2;
        index = index * slab.extent.size(axis) + (middle - slab.extent.min[axis]);
      }
      seeds_.set(tile, sites[index]);
    }
  }
}

} // namespace medial
