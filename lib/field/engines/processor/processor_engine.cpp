#include "field/engines/processor/processor_engine.h"

#include "base/checkpoint.h"
#include "base/extents.h"
#include "base/stopwatch.h"
#include "culling/candidate_tiles.h"
#include "field/engines/processor/brick_evaluator.h"
#include "field/engines/processor/exact_points.h"
#include "field/engines/processor/point_evaluator.h"
#include "field/engines/processor/processor_selection.h"
#include "field/engines/processor/slab_field.h"
#include "field/engines/processor/tile_evaluator.h"
#include "field/field_tap.h"
#include "field/field_writer.h"
#include "field/slabs.h"
#include "sign/side_parts.h"

#include <tbb/enumerable_thread_specific.h>

#include <algorithm>
#include <cstdint>
#include <optional>
#include <vector>

namespace medial
{
namespace
{

/// Bytes per grid point of a slab when crossings are selected: site and side.
constexpr std::size_t kSelectionBytesPerPoint = 5;

/// The current tile of a thread, its memory, and its counts so far.
struct Work
{
  TileField field;
  BrickEvaluator::Workspace bricks;
  GroupList brickGroups;
  double seconds = 0.0;
  std::int64_t pairs = 0;
  std::int64_t evaluations = 0;
};

using Works = tbb::enumerable_thread_specific<Work>;

/// Sets the sides of a part of a tile.
void setSides(const InsideRows& inside, const Extent& part, const Extent& tile, TileField& field)
{
  for (int k = part.min[2]; k <= part.max[2]; ++k)
  {
    for (int j = part.min[1]; j <= part.max[1]; ++j)
    {
      inside.write({ part.min[0], j, k }, part.size(0),
        field.side + TileField::index(part.min[0] - tile.min[0], j - tile.min[1], k - tile.min[2]));
    }
  }
}

/// Computes a job, tile by tile.
class Evaluation
{
public:
  /// @param side that is looked at: tiles of the other are left out where no array is wanted but
  ///   for the axis, or the sink wants this side alone, and it is known beforehand which these are.
  /// @param tap the sink, if it keeps the field for the axis; else null.
  Evaluation(const FieldJob& job, Side side, const FieldSink& sink, const FieldTap* tap)
    : job_(job)
    , side_(side)
    , sinkSide_(sink.side())
    , tap_(tap)
    , hierarchy_(job.host.filter(), job.frame, job.whole, job.extent)
    , sites_(job.host.sites(), job.host.filter().bounds(), job.host.signNormals(), job.frame,
        job.host.filter().slack())
    , bricks_(job.host.filter().tree(), job.frame, job.host.filter().slack())
    , points_(job.host.filter().tree(), job.frame)
    , exact_(job.host.query(), job.frame)
    , inside_(job.insideRows())
    , writer_(job, inside_)
  {
  }

  const TileEvaluator& sites() const { return sites_; }

  /// Computes a slab.
  /// @param field keeps it for the selection; may be null.
  void evaluate(const Extent& slab, const FieldArrays& arrays, const Checkpoint& checkpoint,
    SlabField* field, Works& works)
  {
    writer_.begin(slab, arrays);
    const auto inTile = [&](const Extent& tile, bool sided, const auto& evaluate)
    {
      checkpoint();
      Work& work = works.local();
      const Stopwatch watch(work.seconds);
      const SliceRange slices = SliceRange::common(tile, slab);
      evaluate(slices, work);
      this->finish(tile, slices, sided, work.field);
      writer_.store(tile, work.field);
      if (field != nullptr)
      {
        field->store(tile, work.field);
      }
    };
    CandidateHierarchy::Visitor visitor;
    visitor.sites = [&](const Extent& tile, const std::vector<int>& sites)
    {
      inTile(tile, true,
        [&](const SliceRange& slices, Work& work)
        { this->evaluateSites(tile, sites, slices, work); });
    };
    visitor.groups = [&](const Extent& tile, const BoxReach& reach, const GroupList& groups)
    {
      inTile(tile, false,
        [&](const SliceRange& slices, Work& work)
        { this->evaluateGroups(tile, reach, groups, slices, work); });
    };
    const CullingCounts counts = job_.run.onThreads(
      [&]
      {
        std::optional<SideParts> parts;
        const bool sideOnly =
          tap_ != nullptr ? tap_->sideOnly() : !arrays.any() || sinkSide_ == side_;
        if (side_ != Side::Both && inside_ != nullptr && sideOnly)
        {
          parts.emplace(*inside_, side_, slab, job_.whole, CandidateHierarchy::kTileSize,
            tap_ != nullptr ? FieldTap::kMargin : 0);
          visitor.wanted = [&](const Extent& tiles) { return parts->meets(tiles); };
        }
        return hierarchy_.visitTiles(slab, visitor);
      });
    job_.statistics.groupTests += counts.groupTests;
    job_.statistics.siteTests += counts.siteTests;
  }

private:
  void evaluateSites(const Extent& tile, const std::vector<int>& sites, const SliceRange& slices,
    Work& work) const
  {
    work.pairs += static_cast<std::int64_t>(sites.size());
    work.evaluations += sites_.evaluate(tile, sites.data(), sites.size(), slices, work.field);
  }

  void evaluateGroups(const Extent& tile, const BoxReach& reach, const GroupList& groups,
    const SliceRange& slices, Work& work) const
  {
    work.pairs += static_cast<std::int64_t>(groups.size()) * SiteGroup::kSize;
    // From here on a search for every point takes less time than trying what a brick needs.
    constexpr int kManyGroups = 200;
    if (this->isTooLong(groups, reach))
    {
      std::fill(std::begin(work.field.site), std::end(work.field.site), -1);
    }
    else if (groups.size() > kManyGroups)
    {
      work.evaluations += points_.evaluate(tile, groups, slices, work.field, work.brickGroups);
    }
    else
    {
      work.evaluations += bricks_.evaluate(tile, reach, groups, slices, work.field, work.bricks);
    }
  }

  /// Whether some element reaches so far from a tile that single precision does not tell distances
  /// to 1e-3; exact queries do.
  bool isTooLong(const GroupList& candidates, const BoxReach& reach) const
  {
    constexpr double kMax = 2048.0;
    const glm::dvec3 centre(reach.box().centre);
    const std::vector<int>& ids = candidates.groups();
    return std::any_of(ids.begin(), ids.end(),
      [&](int id)
      {
        const SiteGroup& group = job_.host.filter().tree().groups()[id];
        return glm::distance(group.origin, centre) + static_cast<double>(group.extent) > kMax;
      });
  }

  /// @param sided whether the sides are known where sites are.
  void finish(const Extent& tile, const SliceRange& slices, bool sided, TileField& values) const
  {
    const bool filled = exact_.fill(tile, slices, values);
    if ((filled || !sided) && hasPseudonormals(job_.sign))
    {
      sites_.setSides(tile, slices, values);
    }
    if (inside_ != nullptr)
    {
      setSides(*inside_, commonPart(tile, job_.extent), tile, values);
    }
  }

  const FieldJob& job_;
  Side side_;
  Side sinkSide_;
  const FieldTap* tap_;
  CandidateHierarchy hierarchy_;
  TileEvaluator sites_;
  BrickEvaluator bricks_;
  PointEvaluator points_;
  ExactPoints exact_;
  const InsideRows* inside_;
  FieldWriter writer_;
};

Evaluation makeEvaluation(const FieldJob& job, Side side, const FieldSink& sink,
  const FieldTap* tap = nullptr)
{
  // What is made for all engines, in time of its own.
  job.insideRows();
  job.host.filter();
  job.host.signNormals();
  const Stopwatch watch(job.statistics.seconds.sites);
  return job.run.onThreads([&] { return Evaluation(job, side, sink, tap); });
}

/// Adds the work of all threads. Evaluation and culling alternate; each gets the share of the wall
/// clock that it has of the threads' time.
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

/// Computes all slabs of a job.
/// @param fieldOf returns the memory that keeps a slab for `finish`, or null.
/// @param finish called when a slab is computed, with its share of the progress.
template <typename FieldOf, typename Finish>
void evaluateSlabs(const FieldJob& job, const std::vector<Extent>& slabs, Evaluation& evaluation,
  FieldSink& sink, const FieldOf& fieldOf, const Finish& finish)
{
  Works works;
  double wall = 0.0;
  const double perSlab = 1.0 / static_cast<double>(slabs.size());
  for (std::size_t i = 0; i < slabs.size(); ++i)
  {
    const double done = static_cast<double>(i) * perSlab;
    job.run.report(done, "distance field");
    const Checkpoint checkpoint(job.run, done, "distance field");
    const FieldArrays arrays = sink.slabArrays(slabs[i]);
    SlabField* const field = fieldOf(slabs[i]);
    timed(wall, [&] { evaluation.evaluate(slabs[i], arrays, checkpoint, field, works); });
    sink.stored(slabs[i]);
    finish(done + 0.5 * perSlab);
  }
  addWorks(works, wall, job.run.threads(), job.statistics);
}

} // namespace

void ProcessorEngine::run(const FieldJob& job, FieldSink& sink)
{
  Evaluation evaluation = makeEvaluation(job, sink.side(), sink);
  const int slices = slabSlices(job.extent, sink.bytesPerPoint(), job.memoryMiB);
  evaluateSlabs(
    job, slabsOf(job.extent, slices), evaluation, sink,
    [](const Extent&) -> SlabField* { return nullptr; }, [](double) {});
}

std::vector<Crossing> ProcessorEngine::select(const FieldJob& job, const CrossingSelection& wanted,
  FieldSink& sink)
{
  Evaluation evaluation = makeEvaluation(job, wanted.side, sink, wanted.tap);
  const CrossingFilter filter = timed(job.statistics.seconds.medial,
    [&]
    {
      return job.run.onThreads([&]
        { return CrossingFilter(wanted, job.host.sites(), job.frame, job.host.filter().slack()); });
    });
  ProcessorSelection selection(wanted, job.frame, job.extent, job.sign != FieldSign::None, &filter);
  const auto displacement = [&](int site, const glm::dvec3& x)
  { return evaluation.sites().displacement(site, x); };
  SlabField field;
  const int slices =
    slabSlices(job.extent, kSelectionBytesPerPoint + sink.bytesPerPoint(), job.memoryMiB);
  evaluateSlabs(
    job, slabsOf(job.extent, slices), evaluation, sink,
    [&](const Extent& slab)
    {
      field.begin(slab, wanted.side == Side::Exterior);
      return &field;
    },
    [&](double done)
    {
      job.run.report(done, "distance field");
      const Stopwatch watch(job.statistics.seconds.medial);
      job.run.onThreads([&] { selection.process(field, displacement); });
    });
  return selection.takeCrossings();
}

} // namespace medial
