#include "axis/surface_axis.h"

#include "axis/axis_cells.h"
#include "axis/axis_points.h"
#include "axis/border_rims.h"
#include "axis/crease_rims.h"
#include "axis/dual_mesh.h"
#include "axis/sheet_selection.h"

#include <tbb/parallel_for.h>

#include <array>
#include <cmath>

namespace medial
{
namespace
{

std::array<float, 3> narrowed(const Point3& point)
{
  return { static_cast<float>(point[0]), static_cast<float>(point[1]),
    static_cast<float>(point[2]) };
}

} // namespace

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

BisectorPoints surfaceOf(const AxisGeometry& geometry, std::vector<Crossing>& crossings,
  MedialAxis& axis)
{
  const SheetSelection selection = selectSheets(geometry, crossings);
  const DualMesh& mesh = selection.part.mesh;
  geometry.checkpoint();
  BisectorPoints points = surfacePoints(geometry, mesh, selection.bisectors);
  const auto quads = quadsWithin(mesh, geometry.extent);
  const std::vector<EdgeTable::Edge> rims = rimEdges(mesh.cells, quads);
  const std::vector<std::size_t> elsewhere =
    moveToBorders(geometry, selection, rims, selection.part.origins, points);
  extendRims(geometry, elsewhere, points);
  geometry.checkpoint();
  buildCells(quads, points, axis);
  return points;
}

} // namespace medial
