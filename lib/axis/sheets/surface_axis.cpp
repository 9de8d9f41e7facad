#include "axis/sheets/surface_axis.h"

#include "axis/dual_mesh.h"
#include "axis/sheets/axis_cells.h"
#include "axis/sheets/axis_points.h"
#include "axis/sheets/border_rims.h"
#include "axis/sheets/crease_rims.h"
#include "axis/sheets/sheet_selection.h"

#include <tbb/parallel_invoke.h>

#include <array>
#include <cstdint>
#include <vector>

namespace medial
{

BisectorPoints surfaceOf(const AxisGeometry& geometry, std::vector<Crossing>& crossings,
  MedialAxis& axis, SheetEnds ends)
{
  const SheetSelection selection = selectSheets(geometry, crossings);
  const DualMesh& mesh = selection.part.mesh;
  geometry.checkpoint();
  BisectorPoints points;
  std::vector<std::array<std::int64_t, 4>> quads;
  std::vector<EdgeTable::Edge> rims;
  tbb::parallel_invoke([&] { points = surfacePoints(geometry, selection); },
    [&]
    {
      quads = quadsWithin(mesh, geometry.extent);
      rims = rimEdges(mesh.cells, quads);
    });
  const std::vector<std::size_t> elsewhere = ends == SheetEnds::AtBorder
    ? moveToBorders(geometry, selection, rims, selection.part.origins, points)
    : verticesOn(rims);
  extendRims(geometry, elsewhere, points);
  geometry.checkpoint();
  buildCells(quads, points, axis);
  return points;
}

} // namespace medial
