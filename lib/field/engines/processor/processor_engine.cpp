#include "field/engines/processor/processor_engine.h"

#include "base/checkpoint.h"
#include "base/stopwatch.h"
#include "field/engines/processor/processor_selection.h"
#include "field/engines/processor/slab_field.h"
#include "field/engines/processor/tile_evaluator.h"
#include "field/field_writer.h"
#include "field/slab_culling.h"
#include "field/slabs.h"

#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cstdint>
#include <utility>

namespace medial
{
namespace
{

/// Bytes per grid point of a slab when crossings are selected: site and side.
constexpr std::size_t kSelectionBytesPerPoint = 8;

/// The current tile of a thread, and its counts so far.
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

void setSides(const InsideRows& inside, const Extent& tile, TileField& field)
{
  for (int k = 0; k < tile.size(2); ++k)
  {
    for (int j = 0; j < tile.size(1); ++j)
    {
      inside.write({ tile.min[0], tile.min[1] + j, tile.min[2] + k }, tile.size(0),
        field.side + TileField::index(0, j, k));
    }
  }
}

/// Turns the candidates of tiles into values for a sink.
struct Evaluation
{
  explicit Evaluation(const FieldJob& job)
    : inside(job.inside)
    , evaluator(job.sites, job.normals, job.frame, job.filter.slack())
    , writer(job)
  {
    seeds.reset(job.extent);
  }

  /// Also leaves the tile in work.field. Several threads may call this at once.
  void evaluate(const Extent& tile, const int* candidates, std::size_t count, Work& work)
  {
    work.evaluations += evaluator.evaluate(tile, candidates, count, work.field);
    if (inside != nullptr)
    {
      setSides(*inside, tile, work.field);
    }
    writer.store(tile, work.field);
    seeds.set(tile, middleSite(tile, work.field));
  }

  const InsideRows* inside; ///< null if the evaluator finds the sides
  TileEvaluator evaluator;
  FieldWriter writer;
  ClosestSeeds seeds; ///< for the next job
};

Evaluation makeEvaluation(const FieldJob& job)
{
  const Stopwatch watch(job.statistics.seconds.sites);
  return job.run.onThreads([&] { return Evaluation(job); });
}

/// Evaluates a slab while its tiles are found, so that they need not be listed.
void evaluateSlab(const FieldJob& job, const CandidateHierarchy& hierarchy, const Extent& slab,
  const Checkpoint& checkpoint, Evaluation& evaluation, Works& works)
{
  job.run.onThreads(
    [&]
    {
      hierarchy.visitLeaves(slab,
        [&](const Extent& tile, const std::vector<int>& candidates)
        {
          checkpoint();
          Work& work = works.local();
          const Stopwatch watch(work.seconds);
          work.pairs += static_cast<std::int64_t>(candidates.size());
          evaluation.evaluate(tile, candidates.data(), candidates.size(), work);
        });
    });
}

/// Adds the work of all threads. Evaluation and the descent to leaf tiles alternate; each gets the
/// share of the wall clock that it has of the threads' time.
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

/// Evaluates listed tiles, and keeps them for the selection.
void evaluateTiles(const FieldJob& job, const Extent& slab,
  const std::vector<CandidateTiles>& blocks, const Checkpoint& checkpoint, Evaluation& evaluation,
  SlabField& field)
{
  const Stopwatch watch(job.statistics.seconds.draw);
  field.begin(slab);
  Works works;
  job.run.onThreads(
    [&]
    {
      tbb::parallel_for(std::size_t{ 0 }, blocks.size(),
        [&](std::size_t b)
        {
          checkpoint();
          const CandidateTiles& block = blocks[b];
          Work& work = works.local();
          for (std::size_t t = 0; t < block.tiles.size(); ++t)
          {
            evaluation.evaluate(block.tiles[t], block.candidates.data() + block.offsets[t],
              block.offsets[t + 1] - block.offsets[t], work);
            field.store(block.tiles[t], work.field);
          }
        });
    });
  for (const Work& work : works)
  {
    job.statistics.fragments += work.evaluations;
  }
}

} // namespace

void ProcessorEngine::run(const FieldJob& job, FieldSink& sink)
{
  const int slices = slabSlices(job.extent, sink.bytesPerPoint(), job.memoryMiB);
  const SlabCulling culling(job, slices, TileHull::Points, seeds_);
  Evaluation evaluation = makeEvaluation(job);
  const std::vector<Extent> slabs = slabsOf(job.extent, slices);
  Works works;
  double wall = 0.0;
  for (std::size_t i = 0; i < slabs.size(); ++i)
  {
    const double done = static_cast<double>(i) / static_cast<double>(slabs.size());
    job.run.report(done, "distance field");
    const Checkpoint checkpoint(job.run, done, "distance field");
    evaluation.writer.begin(slabs[i], sink.slabArrays(slabs[i]));
    timed(wall,
      [&] { evaluateSlab(job, culling.hierarchy(), slabs[i], checkpoint, evaluation, works); });
    sink.stored(slabs[i]);
  }
  addWorks(works, wall, job.run.threads(), job.statistics);
  seeds_ = std::move(evaluation.seeds);
}

SelectedField ProcessorEngine::select(const FieldJob& job, const CrossingSelection& wanted,
  FieldSink& sink)
{
  const int slices =
    slabSlices(job.extent, kSelectionBytesPerPoint + sink.bytesPerPoint(), job.memoryMiB);
  SlabCulling culling(job, slices, TileHull::Cells, seeds_);
  Evaluation evaluation = makeEvaluation(job);
  ProcessorSelection selection(wanted, job.frame, job.sign != FieldSign::None);
  const std::vector<Extent> slabs = slabsOf(job.extent, slices);
  const double perSlab = 1.0 / static_cast<double>(slabs.size());
  SlabField field;
  for (std::size_t i = 0; i < slabs.size(); ++i)
  {
    const double done = static_cast<double>(i) * perSlab;
    job.run.report(done, "distance field");
    const Checkpoint checkpoint(job.run, done, "distance field");
    const std::vector<CandidateTiles> blocks = culling.tilesOf(slabs[i], checkpoint);
    evaluation.writer.begin(slabs[i], sink.slabArrays(slabs[i]));
    evaluateTiles(job, slabs[i], blocks, checkpoint, evaluation, field);
    sink.stored(slabs[i]);
    job.run.report(done + 0.5 * perSlab, "distance field");
    const Stopwatch watch(job.statistics.seconds.medial);
    job.run.onThreads([&] { selection.process(field, evaluation.evaluator); });
  }
  seeds_ = std::move(evaluation.seeds);
  return { selection.takeCrossings(), culling.takeQuery() };
}

} // namespace medial
