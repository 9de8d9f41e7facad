#include "axis/closest_pairs.h"

#include "base/separation_angle.h"
#include "sites/closest_point.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace medial
{
namespace
{

/// Sites whose distances differ by less, in local units (voxels), are equally near.
constexpr double kEquallyNear = 1e-9;

/// A site that may have one of the closest points of x.
struct Candidate
{
  SitePoint point;
  double distance; ///< from x
};

Candidate candidateOf(const SiteSet& sites, int site, const glm::dvec3& x)
{
  const SitePoint point = closestPoint(sites, site, x);
  return { point, glm::distance(x, point.point) };
}

/// Candidates side by side.
struct Candidates
{
  const Candidate* first;
  const Candidate* last;

  const Candidate* begin() const { return first; }
  const Candidate* end() const { return last; }
};

/// Whether the separation angle of one point and p is larger than that of the same point and q. It
/// is as if both were computed, but this is hardly ever necessary.
bool isWider(const glm::dvec3& x, const Candidate& one, const Candidate& p, const Candidate& q)
{
  const glm::dvec3 u = one.point.point - x;
  const double towardsP = glm::dot(u, p.point.point - x) * q.distance;
  const double towardsQ = glm::dot(u, q.point.point - x) * p.distance;
  constexpr double kDoubt = 1e-9; // of the cosine
  if (std::abs(towardsP - towardsQ) > kDoubt * one.distance * p.distance * q.distance)
  {
    return towardsP < towardsQ;
  }
  return separationAngle(x, one.point.point, p.point.point) >
    separationAngle(x, one.point.point, q.point.point);
}

/// As oppositePoint().
Candidate opposite(const Candidates& candidates, const glm::dvec3& x, const Candidate& closest,
  double tolerance)
{
  const double farthest = closest.distance + tolerance;
  const Candidate* widest = nullptr;
  for (const Candidate& candidate : candidates)
  {
    if (candidate.distance <= farthest &&
      (widest == nullptr || isWider(x, closest, candidate, *widest)))
    {
      widest = &candidate;
    }
  }
  return widest != nullptr ? *widest : closest;
}

/// Returns the closest pair at x. Where several sites are equally near, as on a seam, the closest
/// point may be that of any of them; then the pair with the largest angle counts.
BisectorPoint widestPair(const Candidates& candidates, const glm::dvec3& x,
  const SitePoint& closestPoint, double tolerance)
{
  const Candidate closest{ closestPoint, glm::distance(x, closestPoint.point) };
  BisectorPoint widest{ x, closestPoint, opposite(candidates, x, closest, tolerance).point };
  for (const Candidate& other : candidates)
  {
    if (other.point.site != closestPoint.site && other.distance <= closest.distance + kEquallyNear)
    {
      const BisectorPoint pair{ x, other.point, opposite(candidates, x, other, tolerance).point };
      widest = pair.separationAngle() > widest.separationAngle() ? pair : widest;
    }
  }
  return widest;
}

/// Replaces `sites` by the sites whose bisectors gave a vertex, each once: ascending, or in the
/// order of the bisectors.
void sitesOf(const DualMesh& mesh, const BisectorPoints& bisectors, std::size_t vertex,
  EqualAngles equalAngles, std::vector<int>& sites)
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
  if (equalAngles == EqualAngles::LowestSite)
  {
    std::sort(sites.begin(), sites.end());
  }
}

} // namespace

SitePoint oppositePoint(const SiteSet& sites, const std::vector<int>& candidates,
  const glm::dvec3& x, const SitePoint& closest, double tolerance)
{
  std::vector<Candidate> points;
  points.reserve(candidates.size());
  for (const int site : candidates)
  {
    points.push_back(candidateOf(sites, site, x));
  }
  return opposite({ points.data(), points.data() + points.size() }, x,
    { closest, glm::distance(x, closest.point) }, tolerance)
    .point;
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
  std::vector<Candidate> candidates;
  for (std::size_t i = 0; i < answers.size(); ++i)
  {
    const glm::dvec3& x = answers[i].x;
    sitesOf(mesh, bisectors, vertices[i], equalAngles, sites);
    candidates.clear();
    for (const int site : sites)
    {
      candidates.push_back(candidateOf(geometry.sites, site, x));
    }
    result[i] = widestPair({ candidates.data(), candidates.data() + candidates.size() }, x,
      answers[i].closest, tolerance);
  }
  return result;
}

std::vector<BisectorPoint> closestPairs(const AxisGeometry& geometry, const DualMesh& mesh,
  const BisectorPoints& bisectors, const std::vector<std::size_t>& vertices,
  const std::vector<glm::dvec3>& positions, double tolerance)
{
  std::vector<int> sites;
  std::vector<Candidate> candidates; // of all vertices
  std::vector<std::size_t> ends(vertices.size());
  std::vector<SiteQuery::Question> questions(vertices.size());
  for (std::size_t i = 0; i < vertices.size(); ++i)
  {
    sitesOf(mesh, bisectors, vertices[i], EqualAngles::LowestSite, sites);
    double nearest = std::numeric_limits<double>::infinity();
    double second = nearest;
    SiteQuery::Question question{ positions[i], {} };
    for (const int site : sites)
    {
      const Candidate candidate = candidateOf(geometry.sites, site, positions[i]);
      candidates.push_back(candidate);
      if (candidate.distance < nearest ||
        (candidate.distance == nearest && candidate.point.site < question.closest.site))
      {
        second = nearest;
        question.other = question.closest.site;
        nearest = candidate.distance;
        question.closest = candidate.point;
      }
      else if (candidate.distance < second)
      {
        second = candidate.distance;
        question.other = candidate.point.site;
      }
    }
    ends[i] = candidates.size();
    questions[i] = question;
  }
  geometry.query.closest(questions);
  std::vector<BisectorPoint> result(vertices.size());
  const Candidate* first = candidates.data();
  for (std::size_t i = 0; i < vertices.size(); ++i)
  {
    const Candidate* const last = candidates.data() + ends[i];
    result[i] = widestPair({ first, last }, positions[i], questions[i].closest, tolerance);
    first = last;
  }
  return result;
}

} // namespace medial
