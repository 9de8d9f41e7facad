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
#include <numeric>
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

  /// Sets the slab and the arrays of the next tiles.
  void begin(const Extent& nextSlab, const FieldArrays& arrays)
  {
    slab = nextSlab;
    writer.begin(slab, arrays);
  }

  /// Evaluates the slab's part of a tile, and leaves it in work.field as well. Several threads may
  /// call this at once.
  void evaluate(const Extent& tile, const int* candidates, std::size_t count, Work& work)
  {
    const SliceRange slices = SliceRange::common(tile, slab);
    work.evaluations += evaluator.evaluate(tile, candidates, count, slices, work.field);
    if (inside != nullptr)
    {
      setSides(*inside, tile, work.field);
    }
    writer.store(tile, work.field);
    const int middle = (tile.size(2) - 1) / 2;
    if (slices.contains(middle))
    {
      const int index = TileField::index((tile.size(0) - 1) / 2, (tile.size(1) - 1) / 2, middle);
      seeds.set(tile, work.field.site[index]);
    }
  }

  const InsideRows* inside; ///< null if the evaluator finds the sides
  TileEvaluator evaluator;
  FieldWriter writer;
  ClosestSeeds seeds; ///< for the next job
  Extent slab;
};

Evaluation makeEvaluation(const FieldJob& job)
{
  const Stopwatch watch(job.statistics.seconds.sites);
  return job.run.onThreads([&] { return Evaluation(job); });
}

/// Evaluates whole layers of blocks while their tiles are found, so that they need not be listed.
void evaluateLayers(const FieldJob& job, const CandidateHierarchy& hierarchy,
  const Checkpoint& checkpoint, Evaluation& evaluation, Works& works)
{
  job.run.onThreads(
    [&]
    {
      hierarchy.visitLeaves(evaluation.slab,
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

std::int64_t evaluations(const Works& works)
{
  return std::accumulate(works.begin(), works.end(), std::int64_t{ 0 },
    [](std::int64_t sum, const Work& work) { return sum + work.evaluations; });
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
  }
  statistics.fragments += evaluations(works);
  seconds = std::min(seconds, wall);
  statistics.seconds.draw += seconds;
  statistics.seconds.cull += wall - seconds;
}

/// Evaluates those of some listed tiles that the slab cuts.
/// @param field keeps them for the selection; may be null.
void evaluateTiles(const FieldJob& job, const std::vector<CandidateTiles>& blocks,
  const Checkpoint& checkpoint, Evaluation& evaluation, SlabField* field, Works& works)
{
  const auto evaluate = [&](const CandidateTiles& block, std::size_t t, Work& work)
  {
    const Extent& tile = block.tiles[t];
    if (tile.max[2] < evaluation.slab.min[2] || tile.min[2] > evaluation.slab.max[2])
    {
      return;
    }
    evaluation.evaluate(tile, block.candidates.data() + block.offsets[t],
      block.offsets[t + 1] - block.offsets[t], work);
    if (field != nullptr)
    {
      field->store(tile, work.field);
    }
  };
  job.run.onThreads(
    [&]
    {
      tbb::parallel_for(std::size_t{ 0 }, blocks.size(),
        [&](std::size_t b)
        {
          checkpoint();
          Work& work = works.local();
          const Stopwatch watch(work.seconds);
          for (std::size_t t = 0; t < blocks[b].tiles.size(); ++t)
          {
            evaluate(blocks[b], t, work);
          }
        });
    });
}

/// Evaluates a slab; its tiles are listed only if it shares them with others.
void evaluateSlab(const FieldJob& job, SlabCulling& culling, const Checkpoint& checkpoint,
  Evaluation& evaluation, Works& works)
{
  const Extent layers = culling.hierarchy().layersOf(evaluation.slab);
  if (layers.size(2) == evaluation.slab.size(2))
  {
    evaluateLayers(job, culling.hierarchy(), checkpoint, evaluation, works);
  }
  else
  {
    evaluateTiles(job, *culling.tilesOf(evaluation.slab, checkpoint), checkpoint, evaluation,
      nullptr, works);
  }
}

} // namespace

void ProcessorEngine::run(const FieldJob& job, FieldSink& sink)
{
  SlabCulling culling(job, TileHull::Points, seeds_);
  const int slices =
    slabSlices(job.extent, sink.bytesPerPoint(), job.memoryMiB, culling.hierarchy().blockBytes());
  Evaluation evaluation = makeEvaluation(job);
  const std::vector<Extent> slabs = slabsOf(job.extent, slices);
  Works works;
  double wall = 0.0;
  for (std::size_t i = 0; i < slabs.size(); ++i)
  {
    const double done = static_cast<double>(i) / static_cast<double>(slabs.size());
    job.run.report(done, "distance field");
    const Checkpoint checkpoint(job.run, done, "distance field");
    evaluation.begin(slabs[i], sink.slabArrays(slabs[i]));
    timed(wall, [&] { evaluateSlab(job, culling, checkpoint, evaluation, works); });
    sink.stored(slabs[i]);
  }
  addWorks(works, wall, job.run.threads(), job.statistics);
  seeds_ = std::move(evaluation.seeds);
}

SelectedField ProcessorEngine::select(const FieldJob& job, const CrossingSelection& wanted,
  FieldSink& sink)
{
  SlabCulling culling(job, TileHull::Cells, seeds_);
  const int slices = slabSlices(job.extent, kSelectionBytesPerPoint + sink.bytesPerPoint(),
    job.memoryMiB, culling.hierarchy().blockBytes());
  Evaluation evaluation = makeEvaluation(job);
  ProcessorSelection selection(wanted, job.frame, job.extent, job.sign != FieldSign::None);
  const std::vector<Extent> slabs = slabsOf(job.extent, slices);
  const double perSlab = 1.0 / static_cast<double>(slabs.size());
  SlabField field;
  for (std::size_t i = 0; i < slabs.size(); ++i)
  {
    const double done = static_cast<double>(i) * perSlab;
    job.run.report(done, "distance field");
    const Checkpoint checkpoint(job.run, done, "distance field");
    const auto tiles = culling.tilesOf(slabs[i], checkpoint);
    evaluation.begin(slabs[i], sink.slabArrays(slabs[i]));
    timed(job.statistics.seconds.draw,
      [&]
      {
        Works works;
        field.begin(slabs[i]);
        evaluateTiles(job, *tiles, checkpoint, evaluation, &field, works);
        job.statistics.fragments += evaluations(works);
      });
    sink.stored(slabs[i]);
    job.run.report(done + 0.5 * perSlab, "distance field");
    const Stopwatch watch(job.statistics.seconds.medial);
    job.run.onThreads([&] { selection.process(field, evaluation.evaluator); });
  }
  seeds_ = std::move(evaluation.seeds);
  return { selection.takeCrossings(), culling.takeQuery() };
}

} // namespace medial
