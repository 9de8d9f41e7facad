#include "axis/closest_pairs.h"

#include "base/separation_angle.h"
#include "sites/closest_point.h"

#include <algorithm>

namespace medial
{
namespace
{

/// Among the points of sites at most `tolerance` farther away than the closest point, returns the
/// one seen at the largest angle from it.
SitePoint oppositePoint(const SiteSet& sites, const std::vector<int>& candidates,
  const glm::dvec3& x, const SitePoint& closest, double tolerance)
{
  const double farthest = glm::distance(x, closest.point) + tolerance;
  double widest = -1.0;
  SitePoint opposite = closest;
  for (const int site : candidates)
  {
    const SitePoint candidate = closestPoint(sites, site, x);
    const double angle = separationAngle(x, closest.point, candidate.point);
    if (angle > widest && glm::distance(x, candidate.point) <= farthest)
    {
      widest = angle;
      opposite = candidate;
    }
  }
  return opposite;
}

} // namespace

glm::dvec3 meanCrossing(const DualMesh& mesh, const BisectorPoints& bisectors, std::size_t vertex)
{
  glm::dvec3 sum(0.0);
  for (std::size_t i = mesh.offsets[vertex]; i < mesh.offsets[vertex + 1]; ++i)
  {
    sum += bisectors.points[mesh.incident[i]].position;
  }
  return sum / static_cast<double>(mesh.offsets[vertex + 1] - mesh.offsets[vertex]);
}

void sitesOf(const DualMesh& mesh, const BisectorPoints& bisectors, std::size_t vertex,
  std::vector<int>& sites)
{
  sites.clear();
  for (std::size_t i = mesh.offsets[vertex]; i < mesh.offsets[vertex + 1]; ++i)
  {
    const BisectorPoint& bisector = bisectors.points[mesh.incident[i]];
    for (const int site : { bisector.a.site, bisector.b.site })
    {
      if (std::find(sites.begin(), sites.end(), site) == sites.end())
      {
        sites.push_back(site);
      }
    }
  }
}

std::vector<BisectorPoint> closestPairs(const AxisGeometry& geometry,
  std::vector<TileQuery::Question> questions,
  const std::function<void(std::size_t i, std::vector<int>& sites)>& candidates, double tolerance)
{
  geometry.query.closest(questions);
  std::vector<BisectorPoint> result(questions.size());
  std::vector<int> sites;
  for (std::size_t i = 0; i < questions.size(); ++i)
  {
    const auto& [x, closest] = questions[i];
    candidates(i, sites);
    result[i] = { x, closest, oppositePoint(geometry.sites, sites, x, closest, tolerance) };
  }
  return result;
}

} // namespace medial
