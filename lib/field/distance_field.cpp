#include "medial/distance_field.h"

#include "base/memory_guard.h"
#include "field/array_sink.h"
#include "field/field_pipeline.h"
#include "medial/error.h"

#include <string>

namespace medial
{

SignMethod resolveSignMethod(SignMethod requested, const MeshConnectivity& connectivity)
{
  const bool possible = connectivity.closed() && connectivity.oriented();
  switch (requested)
  {
    case SignMethod::Auto:
      return possible ? SignMethod::Pseudonormal : SignMethod::None;
    case SignMethod::Pseudonormal:
      if (!possible)
      {
        throw Error(ErrorCode::InvalidInput,
          "sign method pseudonormal needs a closed, consistently oriented mesh; this one has " +
            std::to_string(connectivity.boundaryEdges) + " boundary, " +
            std::to_string(connectivity.nonManifoldEdges) + " non-manifold and " +
            std::to_string(connectivity.misorientedEdges) + " misoriented edges; use auto or none");
      }
      return requested;
    case SignMethod::None:
      break;
  }
  return SignMethod::None;
}

RunStatistics computeDistanceField(const TriangleMesh& mesh, const MeshConnectivity& connectivity,
  const Grid& grid, const Extent& extent, FieldSink& sink, const DistanceFieldOptions& options)
{
  return withMemoryErrors(extent.pointCount(),
    [&]
    {
      FieldPipeline pipeline(mesh, connectivity, grid, extent, options);
      pipeline.run(sink, nullptr);
      pipeline.execution().report(1.0, "distance field");
      return pipeline.statistics();
    });
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
  const MeshConnectivity connectivity = analyseConnectivity(mesh);
  validateGrid(grid);
  DistanceField field;
  field.grid = grid;
  field.sign = resolveSignMethod(options.sign, connectivity);
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
  return field;
}

} // namespace medial
