#include "medial/compute_distance_field.h"

#include "base/memory_guard.h"
#include "base/run.h"
#include "field/array_sink.h"
#include "field/engines/make_engine.h"
#include "field/field_pipeline.h"
#include "pipeline/frame_stages.h"

namespace medial
{

RunStatistics computeField(const TriangleMesh& mesh, const MeshConnectivity& connectivity,
  const Grid& grid, const Extent& extent, FieldSink& sink, const DistanceFieldOptions& options,
  MeshState& state)
{
  return withMemoryErrors(extent.pointCount(),
    [&]
    {
      const Run run(options.execution);
      FieldPipeline pipeline(mesh, connectivity, grid, extent, options, state.orienter, run);
      pipeline.run(obtainEngine(options, state.engine), sink);
      run.report(1.0, "distance field");
      return pipeline.statistics();
    });
}

RunStatistics computeDistanceField(const TriangleMesh& mesh, const MeshConnectivity& connectivity,
  const Grid& grid, const Extent& extent, FieldSink& sink, const DistanceFieldOptions& options)
{
  MeshState state;
  return computeField(mesh, connectivity, grid, extent, sink, options, state);
}

RunStatistics computeDistanceField(const TriangleMesh& mesh, const MeshConnectivity& connectivity,
  const Grid& grid, const Extent& extent, const FieldArrays& arrays,
  const DistanceFieldOptions& options)
{
  ArraySink sink(extent, arrays);
  return computeDistanceField(mesh, connectivity, grid, extent, sink, options);
}

DistanceField computeDistanceField(const TriangleMesh& mesh, const Grid& grid,
  const DistanceFieldOptions& options)
{
  const MeshConnectivity connectivity = analyseConnectivity(mesh, options.execution);
  validateGrid(grid);
  DistanceField field;
  field.grid = grid;
  const auto count = static_cast<std::size_t>(grid.pointCount());
  withMemoryErrors(grid.pointCount(),
    [&]
    {
      field.distance.resize(count);
      field.closestPoint.resize(3 * count);
      field.closestSite.resize(count);
      field.closestFeature.resize(count);
      field.closestCell.resize(count);
    });
  const FieldArrays arrays{ field.distance.data(), field.closestPoint.data(),
    field.closestSite.data(), field.closestFeature.data(), field.closestCell.data() };
  field.statistics =
    computeDistanceField(mesh, connectivity, grid, grid.wholeExtent(), arrays, options);
  field.sign = field.statistics.sign.method;
  return field;
}

} // namespace medial
