#include "medial/medial/axis_points.h"

#include "medial/medial/plane_fit.h"
#include "medial/medial/separation.h"
#include "medial/sites/closest_point.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <cmath>
#include <optional>

namespace medial
{
namespace
{

/// How far outside of its cell a vertex may lie, in steps of the grid.
constexpr double kOutside = 0.1;

/// The two closest points at x: the closest one, and of the sites whose bisectors gave the vertex
/// the one that is seen under the largest angle from it.
BisectorPoint contacts(const AxisGeometry& geometry, const DualMesh& mesh,
  const std::vector<BisectorPoint>& bisectors, std::size_t vertex, const glm::dvec3& x)
{
  const std::size_t begin = mesh.offsets[vertex];
  const std::size_t end = mesh.offsets[vertex + 1];
  BisectorPoint result;
  result.position = x;
  const int known = bisectors[mesh.incident[begin]].a.site;
  result.a = geometry.query.closest(x,
    glm::distance(x, closestPoint(geometry.sites, known, x).point));
  double widest = -1.0;
  for (std::size_t i = begin; i < end; ++i)
  {
    const BisectorPoint& bisector = bisectors[mesh.incident[i]];
    for (const int site : { bisector.a.site, bisector.b.site })
    {
      const SitePoint candidate = closestPoint(geometry.sites, site, x);
      const double angle = separationAngle(x, result.a.point, candidate.point);
      if (angle > widest)
      {
        widest = angle;
        result.b = candidate;
      }
    }
  }
  return result;
}

bool insideGrid(const AxisGeometry& geometry, const glm::dvec3& x)
{
  const glm::dvec3 index = (x - geometry.frame.first) / geometry.frame.step;
  for (int axis = 0; axis < 3; ++axis)
  {
    if (index[axis] < geometry.extent.min[axis] || index[axis] > geometry.extent.max[axis])
    {
      return false;
    }
  }
  return true;
}

/// The next point of the axis along the normal of x's closest point.
std::optional<BisectorPoint> alongNormal(const AxisGeometry& geometry, const BisectorPoint& x,
  double reach)
{
  const double radius = x.radius();
  if (radius <= 0.0)
  {
    return std::nullopt;
  }
  const glm::dvec3 away = (x.position - x.a.point) / radius;
  const glm::dvec3 end = x.position + reach * away;
  if (!insideGrid(geometry, end))
  {
    return std::nullopt;
  }
  const SitePoint other = geometry.query.closest(end, radius + reach);
  if (separationAngle(end, end - away, other.point) < geometry.angle)
  {
    return std::nullopt;
  }
  const BisectorPoint found =
    bisectorPoint(geometry.sites, geometry.query, x.position, x.a.site, end, other.site);
  if (found.separationAngle() < geometry.angle)
  {
    return std::nullopt;
  }
  return found;
}

glm::dvec3 fitted(const AxisGeometry& geometry, const DualMesh& mesh,
  const std::vector<BisectorPoint>& bisectors, std::size_t vertex, PlaneFit& fit)
{
  fit.clear();
  for (std::size_t i = mesh.offsets[vertex]; i < mesh.offsets[vertex + 1]; ++i)
  {
    const BisectorPoint& point = bisectors[mesh.incident[i]];
    const double sine = point.lambda() / point.radius();
    fit.add(point.position, point.normal(), sine * sine);
  }
  const glm::dvec3 centre = geometry.frame.sample(glm::dvec3(mesh.cells[vertex]) + 0.5);
  return fit.solve(centre, (0.5 + kOutside) * geometry.frame.step);
}

template <typename Place>
AxisPoints placeVertices(const DualMesh& mesh, const Place& place)
{
  AxisPoints result;
  result.points.resize(mesh.cells.size());
  result.moved.resize(mesh.cells.size());
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, mesh.cells.size(), 256),
    [&](const tbb::blocked_range<std::size_t>& range)
    {
      PlaneFit fit;
      for (std::size_t v = range.begin(); v != range.end(); ++v)
      {
        place(v, fit, result);
      }
    });
  return result;
}

} // namespace

AxisPoints surfacePoints(const AxisGeometry& geometry, const DualMesh& mesh,
  const std::vector<BisectorPoint>& bisectors)
{
  const double step =
    glm::max(geometry.frame.step.x, glm::max(geometry.frame.step.y, geometry.frame.step.z));
  const double reach = step * (0.5 / std::sin(0.5 * geometry.angle) + 0.5);
  return placeVertices(mesh,
    [&](std::size_t v, PlaneFit& fit, AxisPoints& result)
    {
      const glm::dvec3 x = fitted(geometry, mesh, bisectors, v, fit);
      result.points[v] = contacts(geometry, mesh, bisectors, v, x);
      if (result.points[v].separationAngle() < geometry.angle)
      {
        if (const auto point = alongNormal(geometry, result.points[v], reach))
        {
          result.points[v] = *point;
          result.moved[v] = 1;
        }
      }
    });
}

AxisPoints cellCentres(const AxisGeometry& geometry, const DualMesh& mesh,
  const std::vector<BisectorPoint>& bisectors)
{
  return placeVertices(mesh,
    [&](std::size_t v, PlaneFit&, AxisPoints& result)
    {
      const glm::dvec3 x = geometry.frame.sample(glm::dvec3(mesh.cells[v]) + 0.5);
      result.points[v] = contacts(geometry, mesh, bisectors, v, x);
    });
}

} // namespace medial
