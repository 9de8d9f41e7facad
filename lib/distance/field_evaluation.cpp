#include "medial/common/stopwatch.h"
#include "medial/distance/field_slab.h"
#include "medial/distance/tile_evaluator.h"
#include "medial/gpu/gpu_thread.h"

#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <array>

// The processor as evaluator of candidate tiles, where OpenGL is a software renderer.
namespace medial
{
namespace
{

/// What a grid point of a slab costs with a stage: textures, two slabs on the host and the stage's
/// own textures.
constexpr std::size_t kStagedBytesPerPoint = 80;

/// One thread's tile, and what it has done.
struct Work
{
  TileField field;
  double seconds = 0.0;
  std::int64_t pairs = 0;
  std::int64_t evaluations = 0;
};

using Works = tbb::enumerable_thread_specific<Work>;

int middleSite(const Extent& tile, const TileField& field)
{
  return field
    .site[TileField::index((tile.size(0) - 1) / 2, (tile.size(1) - 1) / 2, (tile.size(2) - 1) / 2)];
}

/// Adds what the threads did. Evaluation and the descent to leaf tiles are interleaved; the wall
/// clock is shared out by the evaluation's part of the threads' time.
void addWorks(const Works& works, double wall, int threads, RunStatistics& statistics)
{
  double seconds = 0.0;
  for (const Work& work : works)
  {
    seconds += work.seconds / threads;
    statistics.candidatePairs += work.pairs;
    statistics.fragments += work.evaluations;
  }
  seconds = std::min(seconds, wall);
  statistics.seconds.draw += seconds;
  statistics.seconds.cull += wall - seconds;
}

} // namespace

void FieldPipeline::evaluate(FieldSink& sink)
{
  const int slices = this->slabSlices(sink.bytesPerPoint());
  const CandidateHierarchy hierarchy = this->cullBlocks(slices, TileHull::Points);
  const TileEvaluator evaluator = this->makeEvaluator();
  FieldWriter writer = this->makeWriter();
  const std::vector<Extent> extents = this->slabsOf(slices);
  Works works;
  double wall = 0.0;
  for (std::size_t i = 0; i < extents.size(); ++i)
  {
    this->report(static_cast<double>(i) / static_cast<double>(extents.size()), "distance field");
    writer.begin(extents[i], sink.slabArrays(extents[i]));
    timed(wall,
      [&]
      {
        this->inArena(
          [&]
          {
            hierarchy.visitLeaves(extents[i],
              [&](const Extent& tile, const std::vector<int>& candidates)
              {
                Work& work = works.local();
                const Stopwatch watch(work.seconds);
                work.pairs += static_cast<std::int64_t>(candidates.size());
                work.evaluations +=
                  evaluator.evaluate(tile, candidates.data(), candidates.size(), work.field);
                writer.store(tile, work.field);
                nextSeeds_.set(tile, middleSite(tile, work.field));
              });
          });
      });
    sink.stored(extents[i]);
  }
  addWorks(works, wall, this->threads(), statistics_);
}

TileEvaluator FieldPipeline::makeEvaluator()
{
  const Stopwatch watch(statistics_.seconds.sites);
  tbb::task_arena arena(this->threads());
  return arena.execute([this] { return TileEvaluator(sites_, normals_, frame_, filter_.slack()); });
}

void FieldPipeline::evaluateForStage(FieldSink& sink, SlabStage& stage)
{
  const AtlasLayout atlas = this->chooseAtlas(kStagedBytesPerPoint + sink.bytesPerPoint());
  const CandidateHierarchy hierarchy = this->cullBlocks(atlas.slabSlices, TileHull::Cells);
  const TileEvaluator evaluator = this->makeEvaluator();
  Renderer& renderer = this->obtainRenderer(atlas);
  FieldWriter writer = this->makeWriter();
  const std::vector<Extent> extents = this->slabsOf(atlas.slabSlices);
  const double perSlab = shareOfField(true) / static_cast<double>(extents.size());
  std::array<Slab, 2> ring;
  InFlight inFlight;
  for (std::size_t i = 0; i < extents.size(); ++i)
  {
    const auto start = static_cast<double>(i);
    this->report(start * perSlab, "distance field");
    Slab& slab = ring[i % 2];
    slab.extent = extents[i];
    slab.previousSlices = i > 0 ? extents[i - 1].size(2) : 0;
    this->cullSlab(hierarchy, slab);
    writer.begin(slab.extent, sink.slabArrays(slab.extent));
    this->evaluateTiles(evaluator, slab, writer);
    sink.stored(slab.extent);
    this->report((start + 0.5) * perSlab, "distance field");
    inFlight.finish();
    inFlight.job =
      renderer.submit([this, &slab, &stage](SlabRenderer& r) { this->runStage(r, slab, stage); });
  }
  inFlight.finish();
  this->addGpuSeconds();
}

void FieldPipeline::evaluateTiles(const TileEvaluator& evaluator, Slab& slab,
  const FieldWriter& writer)
{
  const Stopwatch watch(statistics_.seconds.draw);
  slab.displacements.resize(static_cast<std::size_t>(slab.extent.pointCount()));
  slab.sites.resize(slab.displacements.size());
  Works works;
  this->inArena(
    [&]
    {
      tbb::parallel_for(std::size_t{ 0 }, slab.tiles.size(),
        [&](std::size_t b)
        {
          const CandidateTiles& block = slab.tiles[b];
          Work& work = works.local();
          for (std::size_t t = 0; t < block.tiles.size(); ++t)
          {
            work.evaluations +=
              evaluator.evaluate(block.tiles[t], block.candidates.data() + block.offsets[t],
                block.offsets[t + 1] - block.offsets[t], work.field);
            writer.store(block.tiles[t], work.field);
            nextSeeds_.set(block.tiles[t], middleSite(block.tiles[t], work.field));
            this->resolveTile(evaluator, block.tiles[t], work.field, slab);
          }
        });
    });
  for (const Work& work : works)
  {
    statistics_.fragments += work.evaluations;
  }
}

void FieldPipeline::resolveTile(const TileEvaluator& evaluator, const Extent& tile,
  const TileField& field, Slab& slab) const
{
  for (int k = 0; k < tile.size(2); ++k)
  {
    for (int j = 0; j < tile.size(1); ++j)
    {
      const std::size_t row =
        static_cast<std::size_t>(tile.min[2] + k - slab.extent.min[2]) * slab.extent.size(1) +
        (tile.min[1] + j - slab.extent.min[1]);
      const std::size_t start = row * slab.extent.size(0) + (tile.min[0] - slab.extent.min[0]);
      for (int i = 0; i < tile.size(0); ++i)
      {
        const int point = TileField::index(i, j, k);
        const glm::dvec3 x = frame_.sample({ tile.min[0] + i, tile.min[1] + j, tile.min[2] + k });
        const float side = sign_ == SignMethod::None ? 1.0f : field.side[point];
        slab.sites[start + i] = field.site[point];
        slab.displacements[start + i] = evaluator.displacement(field.site[point], x, side);
      }
    }
  }
}

void FieldPipeline::runStage(SlabRenderer& renderer, Slab& slab, SlabStage& stage)
{
  const Stopwatch watch(gpuSeconds_.medial);
  if (slab.previousSlices > 0)
  {
    renderer.carryLastSlice(slab.previousSlices);
  }
  renderer.setResolved(slab.displacements.data(), slab.sites.data(), slab.extent.size(2));
  stage.process(renderer, slab.extent, slab.previousSlices > 0);
}

} // namespace medial
