#include "axis/closest_pairs.h"

#include "base/separation_angle.h"
#include "sites/closest_point.h"

#include <algorithm>

namespace medial
{
namespace
{

/// Sites whose distances differ by less, in local units (voxels), are equally near.
constexpr double kEquallyNear = 1e-9;

/// Returns the closest pair at x. Where several sites are equally near, as on a seam, the closest
/// point may be that of any of them; then the pair with the largest angle counts.
BisectorPoint widestPair(const SiteSet& sites, const std::vector<int>& candidates,
  const glm::dvec3& x, const SitePoint& closest, double tolerance)
{
  BisectorPoint widest{ x, closest, oppositePoint(sites, candidates, x, closest, tolerance) };
  const double nearest = glm::distance(x, closest.point) + kEquallyNear;
  for (const int site : candidates)
  {
    const SitePoint other = closestPoint(sites, site, x);
    if (other.site != closest.site && glm::distance(x, other.point) <= nearest)
    {
      const BisectorPoint pair{ x, other, oppositePoint(sites, candidates, x, other, tolerance) };
      widest = pair.separationAngle() > widest.separationAngle() ? pair : widest;
    }
  }
  return widest;
}

/// Replaces `sites` by the sites whose bisectors gave a vertex, each once, in the order of the
/// bisectors.
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

} // namespace

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

glm::dvec3 meanCrossing(const DualMesh& mesh, const BisectorPoints& bisectors, std::size_t vertex)
{
  glm::dvec3 sum(0.0);
  for (std::size_t i = mesh.offsets[vertex]; i < mesh.offsets[vertex + 1]; ++i)
  {
    sum += bisectors.points[mesh.incident[i]].position;
  }
  return sum / static_cast<double>(mesh.offsets[vertex + 1] - mesh.offsets[vertex]);
}

std::vector<BisectorPoint> closestPairs(const AxisGeometry& geometry, const DualMesh& mesh,
  const BisectorPoints& bisectors, const std::vector<std::size_t>& vertices,
  const std::vector<SiteQuery::Question>& answers, EqualAngles equalAngles, double tolerance)
{
  std::vector<BisectorPoint> result(answers.size());
  std::vector<int> sites;
  for (std::size_t i = 0; i < answers.size(); ++i)
  {
    const auto& [x, closest] = answers[i];
    sitesOf(mesh, bisectors, vertices[i], sites);
    if (equalAngles == EqualAngles::LowestSite)
    {
      std::sort(sites.begin(), sites.end());
    }
    result[i] = widestPair(geometry.sites, sites, x, closest, tolerance);
  }
  return result;
}

} // namespace medial
