#include "axis/sheets/axis_points.h"

#include "axis/closest_pairs.h"
#include "axis/plane_fit.h"
#include "axis/tile_order.h"
#include "base/huge_pages.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <limits>
#include <optional>
#include <utility>

namespace medial
{
namespace
{

/// How far outside its cell a vertex may lie, in grid steps.
constexpr double kOutside = 0.1;

/// How much farther away than the closest point the other one may be for the centre of a cell.
constexpr double kAnywhere = std::numeric_limits<double>::infinity();

/// The bisector at a crossing, as PlaneFit takes it.
struct BisectorPlane
{
  glm::dvec3 normal;
  double weight;
};

BisectorPlane planeAt(const BisectorPoint& point)
{
  const double sine = point.lambda() / point.radius();
  return { point.normal(), sine * sine };
}

/// Returns where the bisectors of the cell of a vertex meet, without those that were moved out of
/// it.
/// @param planes of all crossings.
glm::dvec3 fitted(const AxisGeometry& geometry, const DualMesh& mesh,
  const BisectorPoints& bisectors, const std::vector<BisectorPlane>& planes, std::size_t vertex,
  PlaneFit& fit)
{
  fit.clear();
  for (std::size_t i = mesh.offsets[vertex]; i < mesh.offsets[vertex + 1]; ++i)
  {
    const std::size_t crossing = mesh.incident[i];
    if (bisectors.moved[crossing] == 0)
    {
      fit.add(bisectors.points[crossing].position, planes[crossing].normal,
        planes[crossing].weight);
    }
  }
  const glm::dvec3 centre = geometry.frame.sample(glm::dvec3(mesh.cells[vertex]) + 0.5);
  return fit.solve(centre, (0.5 + kOutside) * geometry.frame.step);
}

/// Returns the bisector point of a cell that is nearest to x; all of them have the minimum
/// separation angle.
const BisectorPoint& nearestCrossing(const DualMesh& mesh, const BisectorPoints& bisectors,
  std::size_t vertex, const glm::dvec3& x)
{
  const auto nearer = [&](std::size_t p, std::size_t q)
  {
    return glm::distance(bisectors.points[p].position, x) <
      glm::distance(bisectors.points[q].position, x);
  };
  return bisectors.points[*std::min_element(mesh.incident.begin() + mesh.offsets[vertex],
    mesh.incident.begin() + mesh.offsets[vertex + 1], nearer)];
}

bool allMoved(const DualMesh& mesh, const BisectorPoints& bisectors, std::size_t vertex)
{
  return std::all_of(mesh.incident.begin() + mesh.offsets[vertex],
    mesh.incident.begin() + mesh.offsets[vertex + 1],
    [&](std::size_t crossing) { return bisectors.moved[crossing] != 0; });
}

/// Returns the angle that a vertex must have: if facets of a smooth surface were the reason why a
/// crossing of its cell was selected, the angle of a band.
double minAngle(const AxisGeometry& geometry, const DualMesh& mesh, const BisectorPoints& bisectors,
  std::size_t vertex)
{
  const bool faceted = std::any_of(mesh.incident.begin() + mesh.offsets[vertex],
    mesh.incident.begin() + mesh.offsets[vertex + 1],
    [&](std::size_t crossing)
    { return bisectors.points[crossing].separationAngle() < geometry.limits.angle; });
  return faceted ? bandAngle(geometry.limits.angle) : geometry.limits.angle;
}

/// Places vertices of a surface.
class SurfacePlacer
{
public:
  /// @param known, origins as for surfacePoints().
  SurfacePlacer(const AxisGeometry& geometry, const DualMesh& mesh, const BisectorPoints& bisectors,
    const CellPoints& known, const std::vector<std::size_t>& origins)
    : geometry_(geometry)
    , mesh_(mesh)
    , bisectors_(bisectors)
    , known_(known)
    , origins_(origins)
    , planes_(bisectors.points.size())
  {
    tbb::parallel_for(std::size_t{ 0 }, planes_.size(),
      [&](std::size_t crossing) { planes_[crossing] = planeAt(bisectors_.points[crossing]); });
  }

  void place(const std::uint32_t* begin, const std::uint32_t* end, BisectorPoints& result) const
  {
    std::vector<std::size_t> narrow;
    this->placeInCells(begin, end, narrow, result);
    std::vector<BisectorPoint> narrowPoints;
    for (const std::size_t v : narrow)
    {
      narrowPoints.push_back(result.points[v]);
    }
    const std::vector<std::optional<BisectorPoint>> others =
      axisAlongNormals(geometry_, narrowPoints);
    for (std::size_t i = 0; i < narrow.size(); ++i)
    {
      const std::size_t v = narrow[i];
      result.points[v] =
        others[i] ? *others[i] : nearestCrossing(mesh_, bisectors_, v, narrowPoints[i].position);
      result.moved[v] = 1;
    }
  }

private:
  /// @param narrow set to the vertices whose separation angle is too small.
  void placeInCells(const std::uint32_t* begin, const std::uint32_t* end,
    std::vector<std::size_t>& narrow, BisectorPoints& result) const
  {
    PlaneFit fit;
    std::vector<std::size_t> vertices;
    std::vector<glm::dvec3> positions;
    for (const std::uint32_t* at = begin; at != end; ++at)
    {
      const std::size_t v = *at;
      if (allMoved(mesh_, bisectors_, v))
      {
        result.points[v] =
          nearestCrossing(mesh_, bisectors_, v, meanCrossing(mesh_, bisectors_, v));
        result.moved[v] = 1;
      }
      else if (known_.has(origins_[v]))
      {
        this->keep(v, known_.points[origins_[v]], narrow, result);
      }
      else
      {
        vertices.push_back(v);
        positions.push_back(fitted(geometry_, mesh_, bisectors_, planes_, v, fit));
      }
    }
    const std::vector<BisectorPoint> points =
      closestPairs(geometry_, mesh_, bisectors_, vertices, positions, kOffBisector);
    for (std::size_t i = 0; i < vertices.size(); ++i)
    {
      const BisectorPoint& crossing =
        nearestCrossing(mesh_, bisectors_, vertices[i], points[i].position);
      if (geometry_.isAcross(crossing.position, crossing.radius(), points[i]))
      {
        result.points[vertices[i]] = crossing;
        result.moved[vertices[i]] = 1;
      }
      else
      {
        this->keep(vertices[i], points[i], narrow, result);
      }
    }
  }

  void keep(std::size_t v, const BisectorPoint& point, std::vector<std::size_t>& narrow,
    BisectorPoints& result) const
  {
    result.points[v] = point;
    if (!point.reaches(limit_) &&
      point.separationAngle() < minAngle(geometry_, mesh_, bisectors_, v))
    {
      narrow.push_back(v);
    }
  }

  const AxisGeometry& geometry_;
  const DualMesh& mesh_;
  const BisectorPoints& bisectors_;
  const CellPoints& known_;
  const std::vector<std::size_t>& origins_;
  std::vector<BisectorPlane> planes_; ///< of all crossings
  AngleLimit limit_{ geometry_.limits.angle };
};

/// Places vertices at the centres of their cells.
void placeInCentres(const AxisGeometry& geometry, const DualMesh& mesh,
  const BisectorPoints& bisectors, const std::uint32_t* begin, const std::uint32_t* end,
  BisectorPoints& result)
{
  const std::vector<std::size_t> vertices(begin, end);
  std::vector<glm::dvec3> positions(vertices.size());
  std::transform(vertices.begin(), vertices.end(), positions.begin(),
    [&](std::size_t v) { return geometry.frame.sample(glm::dvec3(mesh.cells[v]) + 0.5); });
  const std::vector<BisectorPoint> points =
    closestPairs(geometry, mesh, bisectors, vertices, positions, kAnywhere);
  for (std::size_t i = 0; i < vertices.size(); ++i)
  {
    result.points[vertices[i]] = points[i];
  }
}

/// Places all vertices.
/// @param place called with some of them, close together.
template <typename Place>
BisectorPoints placeVertices(const AxisGeometry& geometry, const DualMesh& mesh, const Place& place)
{
  BisectorPoints result;
  resizeLarge(result.points, mesh.cells.size());
  result.moved.resize(mesh.cells.size());
  const std::vector<std::uint32_t> order = tileOrder(geometry.part, mesh.cells.size(),
    [&](std::size_t vertex) { return mesh.cells[vertex]; });
  inBlocks(geometry, order.size(),
    [&](std::size_t begin, std::size_t end)
    { place(order.data() + begin, order.data() + end, result); });
  return result;
}

} // namespace

BisectorPoints surfacePoints(const AxisGeometry& geometry, const DualMesh& mesh,
  const BisectorPoints& bisectors, const CellPoints& known, const std::vector<std::size_t>& origins)
{
  const SurfacePlacer placer(geometry, mesh, bisectors, known, origins);
  return placeVertices(geometry, mesh,
    [&](const std::uint32_t* begin, const std::uint32_t* end, BisectorPoints& result)
    { placer.place(begin, end, result); });
}

BisectorPoints surfacePoints(const AxisGeometry& geometry, const SheetSelection& selection)
{
  return surfacePoints(geometry, selection.part.mesh, selection.bisectors, selection.cells,
    selection.part.origins);
}

BisectorPoints cellCentres(const AxisGeometry& geometry, const DualMesh& mesh,
  const BisectorPoints& bisectors)
{
  return placeVertices(geometry, mesh,
    [&](const std::uint32_t* begin, const std::uint32_t* end, BisectorPoints& result)
    { placeInCentres(geometry, mesh, bisectors, begin, end, result); });
}

} // namespace medial
