#include "medial/compute_medial_axis.h"

#include "axis/axis_attributes.h"
#include "axis/bisector.h"
#include "axis/dual_mesh.h"
#include "axis/sheets/axis_cells.h"
#include "axis/sheets/axis_points.h"
#include "axis/sheets/sheet_selection.h"
#include "axis/sheets/surface_axis.h"
#include "base/checkpoint.h"
#include "base/memory_guard.h"
#include "base/run.h"
#include "base/stopwatch.h"
#include "field/array_sink.h"
#include "field/engines/make_engine.h"
#include "field/field_pipeline.h"
#include "field/field_tap.h"
#include "medial/axis_curves.h"
#include "medial/error.h"
#include "medial/memory.h"
#include "pipeline/axis_options.h"
#include "pipeline/frame_stages.h"
#include "simplification/simplify_axis.h"
#include "thinning/preserved_axis.h"

#include <tbb/parallel_invoke.h>

#include <memory>
#include <optional>
#include <string>
#include <utility>

namespace medial
{
namespace
{

/// Bytes per grid point for preserving topology: field, voxels, and tables of blocks.
constexpr std::size_t kPreservationBytes = 10;

/// Makes the points and cells of the chosen representation.
BisectorPoints represent(Representation representation, const AxisGeometry& geometry,
  std::vector<Crossing>& crossings, MedialAxis& axis)
{
  if (representation == Representation::Surface)
  {
    return surfaceOf(geometry, crossings, axis);
  }
  if (representation == Representation::Points)
  {
    BisectorPoints points = selectPoints(geometry, crossings);
    buildVertices(points, axis);
    return points;
  }
  const BisectorPoints bisectors = crossingPoints(geometry, crossings);
  const DualMesh mesh = dualMesh(crossings, geometry.part);
  geometry.checkpoint();
  BisectorPoints points = cellCentres(geometry, mesh, bisectors);
  geometry.checkpoint();
  buildCells(quadsWithin(mesh, geometry.extent), points, axis);
  return points;
}

/// Makes points and cells with the topology of the solid. None of them may be contracted or
/// dropped.
BisectorPoints preserve(Representation representation, const AxisGeometry& geometry,
  const FieldTap& field, const std::vector<std::int8_t>& directions,
  std::vector<Crossing>& crossings, MedialAxis& axis)
{
  const SheetSelection selection = selectSheets(geometry, crossings);
  PreservedAxis preserved = preserveTopology(
    { field.distances().data(), field.sites().data(), directions, axis.side, representation },
    geometry, crossings, selection);
  axis.solid = preserved.solid;
  axis.quads = std::move(preserved.cells.quads);
  axis.lines = std::move(preserved.cells.lines);
  axis.vertices = std::move(preserved.cells.vertices);
  return std::move(preserved.cells.points);
}

void simplify(const MedialAxisOptions& options, const Run& run, RunStatistics& statistics,
  MedialAxis& axis)
{
  const Stopwatch watch(statistics.seconds.medial);
  axis = simplifyAxis(axis, options.maxSpheres, run);
}

/// Builds points, cells and features of the axis from the crossings.
/// @param tap the field, if the topology is to be preserved.
/// @param side null without a sign.
void buildAxis(const MedialAxisOptions& options, const FieldPipeline& pipeline, const Grid& grid,
  const FieldTap* tap, const SideCheck* side, const Checkpoint& checkpoint,
  std::vector<Crossing>& crossings, MedialAxis& axis)
{
  const GridFrame& frame = pipeline.frame();
  const AxisGeometry geometry{ pipeline.sites(), pipeline.query(), frame, grid.wholeExtent(),
    grid.wholeExtent(), limitsOf(options, frame), checkpoint, side };
  const BisectorPoints points = tap != nullptr
    ? preserve(options.representation, geometry, *tap, pipeline.directions(), crossings, axis)
    : represent(options.representation, geometry, crossings, axis);
  tbb::parallel_invoke([&] { setAxisPoints(points, frame, axis); },
    [&] { axis.feature = axisFeatures(edgesOf(axis), points.points.size()); });
}

MedialAxis runPipeline(const TriangleMesh& mesh, const MeshConnectivity& connectivity,
  const Grid& grid, const MedialAxisOptions& options, FieldSink& sink, MeshState& state)
{
  const Run run(options.field.execution);
  FieldPipeline pipeline(mesh, connectivity, grid, grid.wholeExtent(), options.field,
    state.orienter, run.part(0.0, kSelectedShare));
  MedialAxis axis;
  axis.sign = pipeline.sign();
  axis.side = sideOf(options.side, axis.sign != SignMethod::None);
  std::optional<FieldTap> tap;
  if (options.topology == Topology::Preserve)
  {
    requireMemory(grid.pointCount(), kPreservationBytes);
    tap.emplace(sink, grid.wholeExtent(), axis.side);
  }
  std::vector<Crossing> crossings =
    pipeline.run(obtainEngine(options.field, state.engine), tap ? *tap : sink,
      CrossingSelection{ selectionAngle(options), axis.side, tap ? &*tap : nullptr });
  run.report(kSelectedShare, "medial axis");
  run.onThreads(
    [&]
    {
      const Stopwatch watch(pipeline.statistics().seconds.medial);
      const Checkpoint checkpoint(run, kSelectedShare, "medial axis");
      const SideCheck side([&] { return pipeline.insideQuery(); });
      buildAxis(options, pipeline, grid, tap ? &*tap : nullptr,
        axis.sign == SignMethod::None ? nullptr : &side, checkpoint, crossings, axis);
    });
  if (options.maxSpheres > 0)
  {
    simplify(options, run.part(0.9, 1.0), pipeline.statistics(), axis);
  }
  run.report(1.0, "medial axis");
  axis.statistics = pipeline.statistics();
  return axis;
}

} // namespace

MedialAxis computeAxis(const TriangleMesh& mesh, const MeshConnectivity& connectivity,
  const Grid& grid, const MedialAxisOptions& options, FieldSink& sink, MeshState& state)
{
  checkAxisOptions(options);
  return withMemoryErrors(grid.pointCount(),
    [&] { return runPipeline(mesh, connectivity, grid, options, sink, state); });
}

MedialAxis computeMedialAxis(const TriangleMesh& mesh, const MeshConnectivity& connectivity,
  const Grid& grid, const MedialAxisOptions& options, FieldSink& sink)
{
  MeshState state;
  return computeAxis(mesh, connectivity, grid, options, sink, state);
}

MedialAxis computeMedialAxis(const TriangleMesh& mesh, const MeshConnectivity& connectivity,
  const Grid& grid, const MedialAxisOptions& options, const FieldArrays& arrays)
{
  ArraySink sink(grid.wholeExtent(), arrays);
  return computeMedialAxis(mesh, connectivity, grid, options, sink);
}

MedialAxis computeMedialAxis(const TriangleMesh& mesh, const Grid& grid,
  const MedialAxisOptions& options)
{
  return computeMedialAxis(mesh, analyseConnectivity(mesh, options.field.execution), grid, options);
}

} // namespace medial
