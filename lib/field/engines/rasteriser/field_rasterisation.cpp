#include "base/stopwatch.h"
#include "field/engines/rasteriser/hole_repair.h"
#include "field/field_slab.h"
#include "gl/gpu_thread.h"

#include <algorithm>
#include <array>

// The rasteriser: polygons that bound Voronoi regions, drawn with the depth test.
namespace medial
{
namespace
{

/// What a grid point of a slab costs: textures, a ring of two pixel buffers, a stage's textures and
/// polygons.
constexpr std::size_t kBytesPerPoint = 112;

} // namespace

void FieldPipeline::rasterise(FieldSink& sink, SlabStage* stage)
{
  const AtlasLayout atlas = this->chooseAtlas(kBytesPerPoint + sink.bytesPerPoint());
  const CandidateHierarchy hierarchy =
    this->cullBlocks(atlas.slabSlices, stage != nullptr ? TileHull::Cells : TileHull::Points);
  Renderer& renderer = this->obtainRenderer(atlas);
  FieldWriter writer = this->makeWriter();
  const std::vector<Extent> extents = this->slabsOf(atlas.slabSlices);
  const double perSlab = shareOfField(stage != nullptr) / static_cast<double>(extents.size());

  std::array<Slab, 2> ring;
  ring[0].arrays = sink.slabArrays(extents[0]);
  const FieldArrays& wanted = ring[0].arrays;
  if (wanted.any())
  {
    renderer.run(
      [&](SlabRenderer&)
      {
        for (Slab& slab : ring)
        {
          slab.readback = std::make_unique<SlabReadback>(atlas, extents[0].size(2),
            wanted.distance || wanted.closestPoint,
            wanted.closestSite || wanted.closestFeature || wanted.closestCell);
        }
      });
  }
  // Pixel buffers go where they came from.
  struct ReleaseReadback
  {
    Renderer& renderer;
    std::array<Slab, 2>& ring;
    ~ReleaseReadback()
    {
      renderer.run(
        [this](SlabRenderer&)
        {
          ring[0].readback.reset();
          ring[1].readback.reset();
        });
    }
  } release{ renderer, ring };

  InFlight inFlight;
  for (std::size_t i = 0; i < extents.size(); ++i)
  {
    const double start = static_cast<double>(i);
    run_.report(start * perSlab, "distance field");
    const Checkpoint checkpoint(run_, start * perSlab, "distance field");
    Slab& slab = ring[i % 2];
    slab.extent = extents[i];
    slab.previousSlices = i > 0 ? extents[i - 1].size(2) : 0;
    this->cullSlab(hierarchy, slab, checkpoint);
    this->clipPolygons(slab, atlas);
    run_.report((start + 0.5) * perSlab, "distance field");
    inFlight.finish();
    inFlight.job =
      renderer.submit([this, &slab, stage](SlabRenderer& r) { this->render(r, slab, stage); });
    if (i > 0)
    {
      this->storeSlab(ring[(i - 1) % 2], writer, sink);
    }
  }
  inFlight.finish();
  this->storeSlab(ring[(extents.size() - 1) % 2], writer, sink);
  this->addGpuSeconds();
}

void FieldPipeline::clipPolygons(Slab& slab, const AtlasLayout& atlas)
{
  const Stopwatch watch(statistics_.seconds.polygons);
  run_.onThreads(
    [&] { slab.chunks = buildPolygons(sites_, frame_, slab.tiles, slab.extent, atlas); });
  double area = 0.0;
  for (const PolygonChunk& chunk : slab.chunks)
  {
    statistics_.polygons += chunk.polygons;
    area += chunk.area;
  }
  statistics_.fragments += static_cast<std::int64_t>(area);
}

void FieldPipeline::render(SlabRenderer& renderer, Slab& slab, SlabStage* stage)
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
        TileQuery query(sites_, filter_, frame_, slab.extent,
          glm::ivec3(CandidateHierarchy::kLeafSize, CandidateHierarchy::kLeafSize,
            std::min(CandidateHierarchy::kLeafSize, renderer.atlas().slabSlices)));
        for (const CandidateTiles& block : slab.tiles)
        {
          query.add(block);
        }
        repairHoles(renderer, normals_, frame_, query, this->fieldSign(), slab.extent);
      }
    });
  if (stage != nullptr)
  {
    const Stopwatch watch(gpuSeconds_.medial);
    stage->process(renderer, slab.extent, slab.previousSlices > 0);
  }
  if (slab.readback)
  {
    const Stopwatch watch(gpuSeconds_.resolve);
    slab.readback->fetch(renderer, slab.extent.size(2));
  }
}

void FieldPipeline::noteSeeds(const Slab& slab)
{
  const std::int32_t* sites = slab.readback->sites();
  if (sites == nullptr)
  {
    return;
  }
  for (const CandidateTiles& block : slab.tiles)
  {
    for (const Extent& tile : block.tiles)
    {
      std::size_t index = 0;
      for (int axis = 2; axis >= 0; --axis)
      {
        const int middle = tile.min[axis] + (tile.max[axis] - tile.min[axis]) / 2;
        index = index * slab.extent.size(axis) + (middle - slab.extent.min[axis]);
      }
      nextSeeds_.set(tile, sites[index]);
    }
  }
}

void FieldPipeline::storeSlab(const Slab& slab, FieldWriter& writer, FieldSink& sink)
{
  // The first slab's arrays are known already.
  const bool first = slab.extent.min[2] == extent_.min[2];
  const FieldArrays arrays = first ? slab.arrays : sink.slabArrays(slab.extent);
  if (slab.readback)
  {
    const Stopwatch watch(statistics_.seconds.resolve);
    writer.begin(slab.extent, arrays);
    run_.onThreads([&] { writer.store(slab.readback->displacements(), slab.readback->sites()); });
    this->noteSeeds(slab);
  }
  sink.stored(slab.extent);
}

} // namespace medial
