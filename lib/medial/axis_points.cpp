#include "medial/medial/axis_points.h"

#include "medial/medial/plane_fit.h"
#include "medial/medial/separation.h"
#include "medial/sites/closest_point.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <limits>
#include <optional>

namespace medial
{
namespace
{

/// How far outside of its cell a vertex may lie, in steps of the grid.
constexpr double kOutside = 0.1;

/// How much farther than the closest point the other one may be, in grid steps: for a vertex that
/// the bisectors place, and for the centre of a cell.
constexpr double kOffBisector = 0.3;
constexpr double kAnywhere = std::numeric_limits<double>::infinity();

/// The two closest points at x: the closest one, and of the sites whose bisectors gave the vertex
/// the one that is seen under the largest angle from it.
BisectorPoint contacts(const AxisGeometry& geometry, const DualMesh& mesh,
  const BisectorPoints& bisectors, std::size_t vertex, const glm::dvec3& x, double tolerance)
{
  const std::size_t begin = mesh.offsets[vertex];
  const std::size_t end = mesh.offsets[vertex + 1];
  BisectorPoint result;
  result.position = x;
  const int known = bisectors.points[mesh.incident[begin]].a.site;
  result.a =
    geometry.query.closest(x, glm::distance(x, closestPoint(geometry.sites, known, x).point));
  result.b = result.a;
  const double farthest = result.radius() + tolerance;
  double widest = -1.0;
  for (std::size_t i = begin; i < end; ++i)
  {
    const BisectorPoint& bisector = bisectors.points[mesh.incident[i]];
    for (const int site : { bisector.a.site, bisector.b.site })
    {
      const SitePoint candidate = closestPoint(geometry.sites, site, x);
      const double angle = separationAngle(x, result.a.point, candidate.point);
      if (angle > widest && glm::distance(x, candidate.point) <= farthest)
      {
        widest = angle;
        result.b = candidate;
      }
    }
  }
  return result;
}

/// Where the bisectors of the vertex's cell meet; those that were moved out of it do not count.
glm::dvec3 fitted(const AxisGeometry& geometry, const DualMesh& mesh,
  const BisectorPoints& bisectors, std::size_t vertex, PlaneFit& fit)
{
  fit.clear();
  for (std::size_t i = mesh.offsets[vertex]; i < mesh.offsets[vertex + 1]; ++i)
  {
    const std::size_t crossing = mesh.incident[i];
    if (bisectors.moved[crossing] == 0)
    {
      const BisectorPoint& point = bisectors.points[crossing];
      const double sine = point.lambda() / point.radius();
      fit.add(point.position, point.normal(), sine * sine);
    }
  }
  const glm::dvec3 centre = geometry.frame.sample(glm::dvec3(mesh.cells[vertex]) + 0.5);
  return fit.solve(centre, (0.5 + kOutside) * geometry.frame.step);
}

/// Of the bisectors' points of a cell, all of which have the least separation angle, the nearest to
/// x.
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

glm::dvec3 meanCrossing(const DualMesh& mesh, const BisectorPoints& bisectors, std::size_t vertex)
{
  glm::dvec3 sum(0.0);
  for (std::size_t i = mesh.offsets[vertex]; i < mesh.offsets[vertex + 1]; ++i)
  {
    sum += bisectors.points[mesh.incident[i]].position;
  }
  return sum / static_cast<double>(mesh.offsets[vertex + 1] - mesh.offsets[vertex]);
}

bool allMoved(const DualMesh& mesh, const BisectorPoints& bisectors, std::size_t vertex)
{
  return std::all_of(mesh.incident.begin() + mesh.offsets[vertex],
    mesh.incident.begin() + mesh.offsets[vertex + 1],
    [&](std::size_t crossing) { return bisectors.moved[crossing] != 0; });
}

template <typename Place>
BisectorPoints placeVertices(const AxisGeometry& geometry, const DualMesh& mesh, const Place& place)
{
  BisectorPoints result;
  result.points.resize(mesh.cells.size());
  result.moved.resize(mesh.cells.size());
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, mesh.cells.size(), 256),
    [&](const tbb::blocked_range<std::size_t>& range)
    {
      geometry.checkpoint();
      PlaneFit fit;
      for (std::size_t v = range.begin(); v != range.end(); ++v)
      {
        place(v, fit, result);
      }
    });
  return result;
}

} // namespace

BisectorPoints surfacePoints(const AxisGeometry& geometry, const DualMesh& mesh,
  const BisectorPoints& bisectors)
{
  return placeVertices(geometry, mesh,
    [&](std::size_t v, PlaneFit& fit, BisectorPoints& result)
    {
      BisectorPoint& point = result.points[v];
      if (allMoved(mesh, bisectors, v))
      {
        point = nearestCrossing(mesh, bisectors, v, meanCrossing(mesh, bisectors, v));
        result.moved[v] = 1;
        return;
      }
      point = contacts(geometry, mesh, bisectors, v, fitted(geometry, mesh, bisectors, v, fit),
        kOffBisector);
      if (point.separationAngle() < geometry.angle)
      {
        const std::optional<BisectorPoint> other = axisAlongNormal(geometry, point);
        point = other ? *other : nearestCrossing(mesh, bisectors, v, point.position);
        result.moved[v] = 1;
      }
    });
}

BisectorPoints cellCentres(const AxisGeometry& geometry, const DualMesh& mesh,
  const BisectorPoints& bisectors)
{
  return placeVertices(geometry, mesh,
    [&](std::size_t v, PlaneFit&, BisectorPoints& result)
    {
      const glm::dvec3 x = geometry.frame.sample(glm::dvec3(mesh.cells[v]) + 0.5);
      result.points[v] = contacts(geometry, mesh, bisectors, v, x, kAnywhere);
    });
}

} // namespace medial
