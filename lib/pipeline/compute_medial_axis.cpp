#include "medial/compute_medial_axis.h"

#include "axis/axis_cells.h"
#include "axis/axis_points.h"
#include "axis/bisector.h"
#include "axis/crease_rims.h"
#include "axis/dual_mesh.h"
#include "base/checkpoint.h"
#include "base/memory_guard.h"
#include "base/separation_angle.h"
#include "base/stopwatch.h"
#include "field/array_sink.h"
#include "field/engines/processor/processor_selection.h"
#include "field/engines/rasteriser/rasteriser_selection.h"
#include "field/field_pipeline.h"
#include "field/field_tap.h"
#include "gl/gpu_thread.h"
#include "medial/axis_curves.h"
#include "medial/error.h"
#include "medial/memory.h"
#include "pipeline/axis_pipeline.h"
#include "simplification/simplify_axis.h"
#include "thinning/preserved_axis.h"

#include <tbb/parallel_for.h>

#include <cmath>
#include <memory>
#include <optional>
#include <string>
#include <utility>

namespace medial
{
namespace
{

/// Bytes a grid point that preservation of topology takes: field, cells and anchors.
constexpr std::size_t kPreservationBytes = 10;
/// Bytes that a crossing takes until the axis is done. From one resolution to another the program
/// took 520 more for each, some of them for files.
constexpr std::size_t kAxisBytes = 400;
/// Share of the work that is done when the axis is selected.
constexpr double kSelected = 0.8;

/// Selects where the evaluator leaves the field: on the GPU or in host memory.
class Selection : public SlabStage
{
public:
  Selection(double angle, Side side, const GridFrame& frame, const RunStatistics& statistics,
    bool signedField)
    : onHost_(angle, side, frame, signedField)
  {
    if (statistics.engine == Engine::Rasteriser)
    {
      onGpu_ = std::make_unique<gl::OnGpuThread<RasteriserSelection>>(angle, side, frame);
    }
  }

  void process(const SlabRenderer& renderer, const Extent& slab, bool carried) override
  {
    onGpu_->object().process(renderer, slab, carried);
    requireRoom(onGpu_->object().crossingCount());
  }
  void process(const SlabField& slab, const TileEvaluator& evaluator) override
  {
    onHost_.process(slab, evaluator);
    requireRoom(onHost_.crossingCount());
  }

  std::vector<Crossing> takeCrossings()
  {
    return onGpu_ ? onGpu_->object().takeCrossings() : onHost_.takeCrossings();
  }

private:
  /// An axis that will not fit is given up at the first slab that shows it.
  static void requireRoom(std::size_t crossings)
  {
    requireMemory("a medial axis selected from " + std::to_string(crossings) + " places or more",
      crossings * kAxisBytes);
  }

  ProcessorSelection onHost_;
  std::unique_ptr<gl::OnGpuThread<RasteriserSelection>> onGpu_;
};

std::array<float, 3> narrowed(const Point3& point)
{
  return { static_cast<float>(point[0]), static_cast<float>(point[1]),
    static_cast<float>(point[2]) };
}

/// Points and attributes in world units.
void setPoints(const BisectorPoints& points, const GridFrame& frame, MedialAxis& axis)
{
  const std::size_t count = points.points.size();
  axis.points.resize(count);
  axis.radius.resize(count);
  axis.separationAngle.resize(count);
  axis.lambda.resize(count);
  axis.closestPointA.resize(count);
  axis.closestPointB.resize(count);
  tbb::parallel_for(std::size_t{ 0 }, count,
    [&](std::size_t p)
    {
      const BisectorPoint& point = points.points[p];
      const double radius = point.radius() * frame.unit;
      const double angle = point.separationAngle();
      axis.points[p] = frame.toWorld(point.position);
      axis.radius[p] = static_cast<float>(radius);
      axis.separationAngle[p] = static_cast<float>(glm::degrees(angle));
      axis.lambda[p] = static_cast<float>(radius * std::sin(0.5 * angle));
      axis.closestPointA[p] = narrowed(frame.toWorld(point.a.point));
      axis.closestPointB[p] = narrowed(frame.toWorld(point.b.point));
    });
}

/// Points and cells of the chosen representation.
BisectorPoints represent(Representation representation, const AxisGeometry& geometry,
  std::vector<Crossing>& crossings, MedialAxis& axis)
{
  const bool exactAngle = representation != Representation::Faces;
  BisectorPoints bisectors = crossingPoints(geometry, exactAngle, crossings);
  if (representation == Representation::Points)
  {
    buildVertices(bisectors, axis);
    return bisectors;
  }
  const DualMesh mesh = dualMesh(crossings, geometry.extent);
  geometry.checkpoint();
  BisectorPoints points;
  if (representation == Representation::Surface)
  {
    points = surfacePoints(geometry, mesh, bisectors);
    extendRims(geometry, mesh, points);
  }
  else
  {
    points = cellCentres(geometry, mesh, bisectors);
  }
  geometry.checkpoint();
  buildCells(mesh.quads, points, axis);
  return points;
}

/// Points and cells with the topology of the solid: nothing of them may be contracted or dropped.
BisectorPoints preserve(Representation representation, const AxisGeometry& geometry,
  const FieldTap& field, std::vector<Crossing>& crossings, MedialAxis& axis)
{
  const BisectorPoints bisectors = crossingPoints(geometry, true, crossings);
  PreservedAxis preserved = preserveTopology(
    { field.distances().data(), field.sites().data(), axis.sign, axis.side, representation },
    geometry, crossings, bisectors);
  axis.solid = preserved.solid;
  axis.quads = std::move(preserved.cells.quads);
  axis.lines = std::move(preserved.cells.lines);
  axis.vertices = std::move(preserved.cells.vertices);
  return std::move(preserved.cells.points);
}

void checkLength(const char* name, double length)
{
  if (!(length >= 0.0) || !std::isfinite(length))
  {
    throw Error(ErrorCode::InvalidInput,
      "least " + std::string(name) + " " + std::to_string(length) + " is outside [0, infinity)");
  }
}

void checkOptions(const MedialAxisOptions& options)
{
  checkSeparationAngle(options.angle);
  checkLength("lambda", options.lambda);
  checkLength("radius", options.radius);
  if (options.topology == Topology::Preserve && options.representation == Representation::Points)
  {
    throw Error(ErrorCode::InvalidInput,
      "points have no topology to preserve: the representation must be surface or faces");
  }
  if (options.maxSpheres < 0)
  {
    throw Error(ErrorCode::InvalidInput,
      "maximum number of spheres " + std::to_string(options.maxSpheres) +
        " is negative; allowed: 0 (no limit) or more");
  }
  if (options.maxSpheres > 0 && options.representation == Representation::Points)
  {
    throw Error(ErrorCode::InvalidInput,
      "maximum number of spheres " + std::to_string(options.maxSpheres) +
        " for an axis of points, which has no cells to simplify; allowed: surface or faces");
  }
}

void simplify(const MedialAxisOptions& options, const Run& run, RunStatistics& statistics,
  MedialAxis& axis)
{
  const Stopwatch watch(statistics.seconds.medial);
  const std::optional<CellTopology> solid = axis.solid;
  axis = simplifyAxis(axis, options.maxSpheres, run);
  axis.solid = solid;
  axis.feature = axisFeatures(edgesOf(axis), axis.points.size());
}

MedialAxis runPipeline(const TriangleMesh& mesh, const MeshConnectivity& connectivity,
  const Grid& grid, const MedialAxisOptions& options, FieldSink& sink, FieldMemory* memory)
{
  FieldPipeline pipeline(mesh, connectivity, grid, grid.wholeExtent(), options.field);
  if (memory != nullptr)
  {
    pipeline.useMemory(*memory);
  }
  MedialAxis axis;
  axis.sign = pipeline.sign();
  axis.side = axis.sign == SignMethod::None ? Side::Both : options.side;
  Selection stage(options.angle, axis.side, pipeline.frame(), pipeline.statistics(),
    axis.sign != SignMethod::None);
  std::optional<FieldTap> tap;
  if (options.topology == Topology::Preserve)
  {
    requireMemory(grid.pointCount(), kPreservationBytes);
    tap.emplace(sink, grid.wholeExtent());
  }
  pipeline.run(tap ? *tap : sink, &stage);
  pipeline.execution().report(kSelected, "medial axis");
  std::vector<Crossing> crossings = stage.takeCrossings();
  pipeline.execution().onThreads(
    [&]
    {
      const Stopwatch watch(pipeline.statistics().seconds.medial);
      const Checkpoint checkpoint(pipeline.execution(), kSelected, "medial axis");
      const AxisGeometry geometry{ pipeline.sites(), pipeline.query(), pipeline.frame(),
        grid.wholeExtent(), glm::radians(options.angle), options.lambda / pipeline.frame().unit,
        options.radius / pipeline.frame().unit, checkpoint };
      const BisectorPoints points = tap
        ? preserve(options.representation, geometry, *tap, crossings, axis)
        : represent(options.representation, geometry, crossings, axis);
      setPoints(points, pipeline.frame(), axis);
      axis.feature = axisFeatures(edgesOf(axis), axis.points.size());
    });
  if (options.maxSpheres > 0)
  {
    simplify(options, pipeline.execution().part(0.9, 1.0), pipeline.statistics(), axis);
  }
  pipeline.execution().report(1.0, "medial axis");
  axis.statistics = pipeline.statistics();
  return axis;
}

} // namespace

MedialAxis computeMedialAxis(const TriangleMesh& mesh, const MeshConnectivity& connectivity,
  const Grid& grid, const MedialAxisOptions& options, FieldSink& sink)
{
  checkOptions(options);
  return withMemoryErrors(grid.pointCount(),
    [&] { return runPipeline(mesh, connectivity, grid, options, sink, nullptr); });
}

MedialAxis computeMedialAxis(const TriangleMesh& mesh, const MeshConnectivity& connectivity,
  const Grid& grid, const MedialAxisOptions& options, const FieldArrays& arrays,
  FieldMemory* memory)
{
  checkOptions(options);
  ArraySink sink(grid.wholeExtent(), arrays);
  return withMemoryErrors(grid.pointCount(),
    [&] { return runPipeline(mesh, connectivity, grid, options, sink, memory); });
}

MedialAxis computeMedialAxis(const TriangleMesh& mesh, const MeshConnectivity& connectivity,
  const Grid& grid, const MedialAxisOptions& options, const FieldArrays& arrays)
{
  return computeMedialAxis(mesh, connectivity, grid, options, arrays, nullptr);
}

MedialAxis computeMedialAxis(const TriangleMesh& mesh, const Grid& grid,
  const MedialAxisOptions& options)
{
  return computeMedialAxis(mesh, analyseConnectivity(mesh), grid, options);
}

} // namespace medial
