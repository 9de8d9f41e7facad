#include "medial/local_thickness.h"

#include "base/checkpoint.h"
#include "base/memory_guard.h"
#include "base/range_check.h"
#include "base/run.h"
#include "base/stopwatch.h"
#include "field/array_sink.h"
#include "field/engines/make_engine.h"
#include "field/field_pipeline.h"
#include "field/mesh_state.h"
#include "field/slabs.h"
#include "medial/error.h"
#include "pipeline/axis_parts.h"
#include "thickness/ball_families.h"
#include "thickness/depth_sink.h"
#include "thickness/slab_thickness.h"
#include "thickness/thickness_tile.h"

#include <algorithm>
#include <limits>
#include <memory>
#include <string>

namespace medial
{
namespace
{

constexpr const char* kPhase = "local thickness";
/// Separation angle of the balls, degrees. Balls with smaller angles stick out of others by less
/// than 2.5 % of their radius: 1 - cos(kBallAngle / 2).
constexpr double kBallAngle = 25.0;
constexpr int kMaxBins = 65536;
/// Slices of a grid in memory between two reports of progress.
constexpr int kSlices = 64;
/// Share of the work that is done once the balls are there.
constexpr double kBallsDone = 0.5;
/// Share of that which is done once the field is there.
constexpr double kFieldDone = 0.6;
/// One in so many bytes of the memory for slabs is for distances that are kept.
constexpr std::size_t kShareOfDepths = 2;

/// Asks for the distances of one side alone; elsewhere they say only that it is the other.
class SideSink : public FieldSink
{
public:
  SideSink(FieldSink& sink, Side side)
    : sink_(sink)
    , side_(side)
  {
  }

  FieldArrays slabArrays(const Extent& slab) override
  {
    const FieldArrays arrays = sink_.slabArrays(slab);
    if (side_ != Side::Both)
    {
      std::fill_n(arrays.distance, slab.pointCount(),
        side_ == Side::Interior ? kFarAway : -kFarAway);
    }
    return arrays;
  }

  void stored(const Extent& slab) override { sink_.stored(slab); }
  std::size_t bytesPerPoint() const override { return sink_.bytesPerPoint(); }
  Side side() const override { return side_; }

private:
  static constexpr float kFarAway = std::numeric_limits<float>::max();

  FieldSink& sink_;
  Side side_;
};

/// Replaces distances on their way to another sink.
class ThicknessSink : public FieldSink
{
public:
  /// @param pipeline that computes the field.
  ThicknessSink(FieldSink& sink, const FieldPipeline& pipeline, SlabThickness& thickness,
    const Run& run, double& seconds)
    : sink_(sink)
    , pipeline_(pipeline)
    , thickness_(thickness)
    , run_(run)
    , seconds_(seconds)
  {
  }

  FieldArrays slabArrays(const Extent& slab) override
  {
    arrays_ = sink_.slabArrays(slab);
    return arrays_;
  }

  void stored(const Extent& slab) override
  {
    {
      const Stopwatch watch(seconds_);
      const Checkpoint checkpoint(run_, 0.0, kPhase);
      const SiteQuery& query = pipeline_.query();
      run_.onThreads([&] { thickness_.replace(slab, query, arrays_.distance, checkpoint); });
    }
    sink_.stored(slab);
  }

  std::size_t bytesPerPoint() const override { return sink_.bytesPerPoint(); }

private:
  FieldSink& sink_;
  const FieldPipeline& pipeline_;
  SlabThickness& thickness_;
  Run run_;
  double& seconds_;
  FieldArrays arrays_;
};

void checkOptions(const LocalThicknessOptions& options)
{
  if (options.bins < 1 || options.bins > kMaxBins)
  {
    throwOutside("number of bins", options.bins, closedRange(1, kMaxBins));
  }
}

/// The parts of the work that do not depend on where the values go.
class LocalThicknessRun
{
public:
  LocalThicknessRun(const TriangleMesh& mesh, const MeshConnectivity& connectivity,
    const Grid& grid, const LocalThicknessOptions& options)
    : mesh_(mesh)
    , connectivity_(connectivity)
    , grid_(grid)
    , options_(options)
    , run_(options.field.execution)
  {
  }

  /// @param sink receives the field; may be null.
  /// @param wanted side of it.
  /// @param kept bytes in which to keep the distances.
  void makeBalls(FieldSink* sink, Side wanted, std::size_t kept)
  {
    const Run part = run_.part(0.0, kBallsDone);
    AxisParts& parts =
      parts_.emplace(mesh_, connectivity_, grid_, this->axisOptions(), part.part(0.0, kFieldDone));
    if (parts.sign() == SignMethod::None)
    {
      throw Error(ErrorCode::InvalidInput,
        "local thickness needs an inside and an outside, but the field has no sign: " +
          parts.statistics().sign.reason);
    }
    const auto keptOf = [&](Side side)
    { return options_.side == side || options_.side == Side::Both ? kept : 0; };
    DepthSink& inner = inner_.emplace(grid_, Side::Interior, sink, run_, keptOf(Side::Interior));
    DepthSink& outer = outer_.emplace(grid_, Side::Exterior, &inner, run_, keptOf(Side::Exterior));
    SideSink sided(outer, wanted);
    parts.computeField(sided);
    inner.dropSlab();
    const double middle = options_.side == Side::Both ? 0.5 * (kFieldDone + 1.0) : kFieldDone;
    if (options_.side != Side::Exterior)
    {
      const double end = options_.side == Side::Both ? middle : 1.0;
      this->makeBalls(parts, Side::Interior, inner, part.part(kFieldDone, end), interior_);
    }
    if (options_.side != Side::Interior)
    {
      this->makeBalls(parts, Side::Exterior, outer, part.part(middle, 1.0), exterior_);
    }
    statistics_.field = parts.statistics();
  }

  /// Whether the distances were kept.
  bool hasDepths() const
  {
    return (options_.side == Side::Exterior || inner_->hasDepths()) &&
      (options_.side == Side::Interior || outer_->hasDepths());
  }
  /// Frees the memory of the first field.
  void dropField()
  {
    parts_.reset();
    inner_.reset();
    outer_.reset();
  }

  /// Replaces the distances of the grid's slabs.
  /// @param distancesOf returns where those of a slab are.
  /// @param replaced is called with each slab.
  template <typename DistancesOf, typename Replaced>
  void replaceSlabs(SlabThickness& thickness, int slices, const DistancesOf& distancesOf,
    const Replaced& replaced)
  {
    for (const Extent& slab : slabsOf(grid_.wholeExtent(), slices))
    {
      float* const distances = distancesOf(slab);
      {
        const Stopwatch watch(statistics_.seconds);
        const double done = static_cast<double>(slab.min[2]) / grid_.dimensions[2];
        const Checkpoint checkpoint(run_, kBallsDone + (1.0 - kBallsDone) * done, kPhase);
        run_.onThreads([&] { thickness.replace(slab, parts_->query(), distances, checkpoint); });
      }
      replaced(slab);
    }
  }

  /// Delivers the thickness of a grid whose distances were kept.
  void replaceDepths(FieldSink& sink, SlabThickness& thickness)
  {
    const int slices =
      slabSlices(grid_.wholeExtent(), sink.bytesPerPoint(), options_.field.memoryMiB);
    replaceSlabs(
      thickness, slices,
      [&](const Extent& slab)
      {
        float* const distances = sink.slabArrays(slab).distance;
        std::fill_n(distances, slab.pointCount(), 0.0f);
        const Stopwatch watch(statistics_.seconds);
        run_.onThreads(
          [&]
          {
            for (const DepthSink* depths : { &*inner_, &*outer_ })
            {
              if (depths->hasDepths())
              {
                depths->readDepths(slab, distances);
              }
            }
          });
        return distances;
      },
      [&](const Extent& slab) { sink.stored(slab); });
  }

  SlabThickness thickness() const
  {
    return { grid_, interior_.of(), exterior_.of(), options_.bins };
  }

  const Run& run() const { return run_; }
  LocalThicknessStatistics& statistics() { return statistics_; }

  LocalThicknessStatistics finished(const SlabThickness& thickness)
  {
    statistics_.thickness = thickness.interior();
    statistics_.separation = thickness.exterior();
    for (const Balls* balls : { &interior_, &exterior_ })
    {
      statistics_.balls += balls->families ? static_cast<std::int64_t>(balls->families->size()) : 0;
    }
    run_.report(1.0, kPhase);
    return statistics_;
  }

private:
  struct Balls
  {
    std::unique_ptr<BallFamilies> families;
    float end = 0.0f;

    SlabThickness::SideBalls of() const { return { families.get(), end }; }
  };

  AxisPartsOptions axisOptions() const
  {
    AxisPartsOptions options;
    options.angle = kBallAngle;
    options.side = options_.side;
    options.ends = SheetEnds::OnGrid; // balls of smaller angles serve as well
    options.field = options_.field;
    return options;
  }

  void makeBalls(AxisParts& parts, Side side, const DepthSink& depths, const Run& part,
    Balls& balls)
  {
    balls.families = std::make_unique<BallFamilies>(grid_, glm::radians(kBallAngle));
    parts.forParts(side, part,
      [&](const MedialAxis& axis, const BallMesh& seams)
      {
        balls.families->add(axis);
        balls.families->add(seams);
      });
    if (side == Side::Exterior || options_.side == Side::Interior)
    {
      parts.dropCrossings(); // since no other side follows
    }
    const Stopwatch watch(statistics_.seconds);
    depths.addBorder(*balls.families);
    run_.onThreads([&] { balls.families->finish(); });
    const double unit = balls.families->unit();
    const float deepest = std::max(static_cast<float>(static_cast<double>(depths.max()) / unit),
      balls.families->maxRadius());
    balls.end = roundedRadius(deepest) * static_cast<float>(2.0 * unit);
  }

  const TriangleMesh& mesh_;
  const MeshConnectivity& connectivity_;
  const Grid& grid_;
  const LocalThicknessOptions& options_;
  Run run_;
  std::optional<AxisParts> parts_;
  std::optional<DepthSink> inner_;
  std::optional<DepthSink> outer_;
  Balls interior_;
  Balls exterior_;
  LocalThicknessStatistics statistics_;
};

} // namespace

LocalThicknessStatistics computeLocalThickness(const TriangleMesh& mesh,
  const MeshConnectivity& connectivity, const Grid& grid, float* values,
  const LocalThicknessOptions& options)
{
  checkOptions(options);
  return withMemoryErrors(grid.pointCount(),
    [&]
    {
      LocalThicknessRun work(mesh, connectivity, grid, options);
      FieldArrays arrays;
      arrays.distance = values;
      ArraySink sink(grid.wholeExtent(), arrays);
      work.makeBalls(&sink, options.side, 0);
      SlabThickness thickness = work.thickness();
      const std::int64_t slice = static_cast<std::int64_t>(grid.dimensions[0]) * grid.dimensions[1];
      work.replaceSlabs(
        thickness, kSlices, [&](const Extent& slab) { return values + slab.min[2] * slice; },
        [](const Extent&) {});
      return work.finished(thickness);
    });
}

LocalThicknessStatistics computeLocalThickness(const TriangleMesh& mesh,
  const MeshConnectivity& connectivity, const Grid& grid, FieldSink& sink,
  const LocalThicknessOptions& options, FieldSink* field)
{
  checkOptions(options);
  return withMemoryErrors(grid.pointCount(),
    [&]
    {
      LocalThicknessRun work(mesh, connectivity, grid, options);
      work.makeBalls(field, field != nullptr ? Side::Both : options.side,
        slabMemory(options.field.memoryMiB) / kShareOfDepths);
      SlabThickness thickness = work.thickness();
      if (work.hasDepths())
      {
        work.replaceDepths(sink, thickness);
        return work.finished(thickness);
      }
      work.dropField();
      const Run part = work.run().part(kBallsDone, 1.0);
      MeshState state;
      FieldPipeline pipeline(mesh, connectivity, grid, grid.wholeExtent(), options.field,
        state.orienter, part);
      ThicknessSink replacing(sink, pipeline, thickness, part, work.statistics().seconds);
      SideSink sided(replacing, options.side);
      pipeline.run(obtainEngine(options.field, state.engine), sided);
      return work.finished(thickness);
    });
}

LocalThickness computeLocalThickness(const TriangleMesh& mesh, const Grid& grid,
  const LocalThicknessOptions& options)
{
  const MeshConnectivity connectivity = analyseConnectivity(mesh, options.field.execution);
  validateGrid(grid);
  LocalThickness thickness;
  thickness.grid = grid;
  withMemoryErrors(grid.pointCount(),
    [&] { thickness.values.resize(static_cast<std::size_t>(grid.pointCount())); });
  thickness.statistics =
    computeLocalThickness(mesh, connectivity, grid, thickness.values.data(), options);
  return thickness;
}

} // namespace medial
