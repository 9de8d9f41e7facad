#include "base/stopwatch.h"
#include "field/engines/processor/tile_evaluator.h"
#include "field/field_slab.h"

#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <algorithm>

// The processor as evaluator of candidate tiles, where OpenGL is a software renderer.
namespace medial
{
namespace
{

/// What a grid point of a slab costs with a stage.
constexpr std::size_t kStagedBytesPerPoint = 8;

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
    const double share = static_cast<double>(i) / static_cast<double>(extents.size());
    run_.report(share, "distance field");
    const Checkpoint checkpoint(run_, share, "distance field");
    writer.begin(extents[i], sink.slabArrays(extents[i]));
    timed(wall,
      [&]
      {
        run_.onThreads(
          [&]
          {
            hierarchy.visitLeaves(extents[i],
              [&](const Extent& tile, const std::vector<int>& candidates)
              {
                checkpoint();
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
  addWorks(works, wall, run_.threads(), statistics_);
}

TileEvaluator FieldPipeline::makeEvaluator()
{
  const Stopwatch watch(statistics_.seconds.sites);
  return run_.onThreads(
    [this] { return TileEvaluator(sites_, normals_, frame_, filter_.slack()); });
}

void FieldPipeline::evaluateForStage(FieldSink& sink, SlabStage& stage)
{
  const int slices = this->slabSlices(kStagedBytesPerPoint + sink.bytesPerPoint());
  const CandidateHierarchy hierarchy = this->cullBlocks(slices, TileHull::Cells);
  const TileEvaluator evaluator = this->makeEvaluator();
  FieldWriter writer = this->makeWriter();
  const std::vector<Extent> extents = this->slabsOf(slices);
  const double perSlab = shareOfField(true) / static_cast<double>(extents.size());
  Slab slab;
  SlabField field;
  for (std::size_t i = 0; i < extents.size(); ++i)
  {
    const auto start = static_cast<double>(i);
    run_.report(start * perSlab, "distance field");
    const Checkpoint checkpoint(run_, start * perSlab, "distance field");
    slab.extent = extents[i];
    this->cullSlab(hierarchy, slab, checkpoint);
    writer.begin(slab.extent, sink.slabArrays(slab.extent));
    this->evaluateTiles(evaluator, slab, writer, field, checkpoint);
    sink.stored(slab.extent);
    run_.report((start + 0.5) * perSlab, "distance field");
    const Stopwatch watch(statistics_.seconds.medial);
    run_.onThreads([&] { stage.process(field, evaluator); });
  }
}

void FieldPipeline::evaluateTiles(const TileEvaluator& evaluator, const Slab& slab,
  const FieldWriter& writer, SlabField& field, const Checkpoint& checkpoint)
{
  const Stopwatch watch(statistics_.seconds.draw);
  field.begin(slab.extent);
  Works works;
  run_.onThreads(
    [&]
    {
      tbb::parallel_for(std::size_t{ 0 }, slab.tiles.size(),
        [&](std::size_t b)
        {
          checkpoint();
          const CandidateTiles& block = slab.tiles[b];
          Work& work = works.local();
          for (std::size_t t = 0; t < block.tiles.size(); ++t)
          {
            work.evaluations +=
              evaluator.evaluate(block.tiles[t], block.candidates.data() + block.offsets[t],
                block.offsets[t + 1] - block.offsets[t], work.field);
            writer.store(block.tiles[t], work.field);
            nextSeeds_.set(block.tiles[t], middleSite(block.tiles[t], work.field));
            field.store(block.tiles[t], work.field);
          }
        });
    });
  for (const Work& work : works)
  {
    statistics_.fragments += work.evaluations;
  }
}

} // namespace medial
