#include "medial/medial/bisector.h"

#include "medial/medial/site_change.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace medial
{
namespace
{

/// Medial balls smaller than this (voxels) are the surface itself.
constexpr double kLeastRadius = 1e-3;
/// Where two sites are this much (voxels) farther than the closest one, their separation angle
/// counts if that of the closest ones is too small: all facets of a round surface have bisectors of
/// their own, which part at its centre.
constexpr double kFacets = 0.1;
/// Sites between the two that are looked for at most.
constexpr int kMaxRounds = 8;

std::optional<BisectorPoint> atLeast(double angle, const BisectorPoint& point)
{
  return point.separationAngle() >= angle ? std::optional(point) : std::nullopt;
}

/// The point at equal distance from both sites, whatever else is as near up to the sag of facets.
/// Nothing where another site is nearer than that, or the separation angle is too small.
std::optional<BisectorPoint> facetedPoint(const AxisGeometry& geometry, const glm::dvec3& from,
  int fromSite, const glm::dvec3& to, int toSite)
{
  BisectorPoint point = SiteChange(geometry.sites, from, fromSite, to, toSite).point();
  if (point.separationAngle() < geometry.angle)
  {
    return std::nullopt;
  }
  const double distance = point.radius();
  const SitePoint closest = geometry.query.closest(point.position, point.a);
  if (glm::distance(closest.point, point.position) < distance - kFacets)
  {
    return std::nullopt;
  }
  const SitePoint other = point.a;
  point.a = closest;
  if (separationAngle(point.position, closest.point, other.point) > point.separationAngle())
  {
    point.b = other;
  }
  return atLeast(geometry.angle, point);
}

/// The same point with one of the sites' points as the second closest.
std::optional<BisectorPoint> widened(const AxisGeometry& geometry, BisectorPoint point,
  int fromSite, int toSite)
{
  const glm::dvec3& x = point.position;
  for (const int site : { fromSite, toSite })
  {
    const SitePoint other = closestPoint(geometry.sites, site, x);
    if (glm::distance(other.point, x) <= point.radius() + kFacets &&
      separationAngle(x, point.a.point, other.point) >= geometry.angle)
    {
      point.b = other;
      return point;
    }
  }
  return std::nullopt;
}

/// A point with the least separation angle between two points with different closest sites.
std::optional<BisectorPoint> axisBetween(const AxisGeometry& geometry, const glm::dvec3& from,
  int fromSite, const glm::dvec3& to, int toSite)
{
  const BisectorPoint exact = bisectorPoint(geometry, from, fromSite, to, toSite);
  if (exact.separationAngle() >= geometry.angle)
  {
    return exact;
  }
  std::optional<BisectorPoint> faceted = facetedPoint(geometry, from, fromSite, to, toSite);
  return faceted ? faceted : widened(geometry, exact, fromSite, toSite);
}

/// The grid points at the ends of a crossed edge.
std::pair<glm::dvec3, glm::dvec3> ends(const GridFrame& frame, const Crossing& crossing)
{
  const glm::dvec3 from = frame.sample(glm::dvec3(crossing.voxel));
  glm::dvec3 to = from;
  to[crossing.axis] += frame.step[crossing.axis];
  return { from, to };
}

/// Crossings in the order of the tiles that they are in.
std::vector<std::size_t> byTile(const TileQuery& query, const std::vector<Crossing>& crossings,
  const tbb::blocked_range<std::size_t>& range)
{
  std::vector<std::pair<std::size_t, std::size_t>> keys;
  keys.reserve(range.size());
  for (std::size_t c = range.begin(); c != range.end(); ++c)
  {
    keys.emplace_back(query.tileIndex(crossings[c].voxel), c);
  }
  std::sort(keys.begin(), keys.end());
  std::vector<std::size_t> order(keys.size());
  std::transform(keys.begin(), keys.end(), order.begin(),
    [](const auto& key) { return key.second; });
  return order;
}

/// bisectorPoint() of many crossings, whose queries go together.
std::vector<SiteChange> settledChanges(const AxisGeometry& geometry,
  const std::vector<Crossing>& crossings, const std::vector<std::size_t>& order)
{
  std::vector<SiteChange> changes;
  changes.reserve(order.size());
  for (const std::size_t c : order)
  {
    const auto [from, to] = ends(geometry.frame, crossings[c]);
    changes.emplace_back(geometry.sites, from, crossings[c].siteA, to, crossings[c].siteB);
  }
  std::vector<std::size_t> open(order.size());
  std::iota(open.begin(), open.end(), std::size_t{ 0 });
  std::vector<TileQuery::Question> questions;
  for (int round = 1; round < kMaxRounds && !open.empty(); ++round)
  {
    questions.clear();
    for (const std::size_t i : open)
    {
      questions.push_back({ changes[i].point().position, changes[i].point().a });
    }
    geometry.query.closest(questions);
    std::size_t left = 0;
    for (std::size_t k = 0; k < open.size(); ++k)
    {
      if (!changes[open[k]].settledBy(questions[k].closest))
      {
        changes[open[k]].narrow(questions[k].closest);
        open[left++] = open[k];
      }
    }
    open.resize(left);
  }
  return changes;
}

/// What becomes of a bisector point; the values are those of BisectorPoints::moved.
enum class Fate : std::uint8_t
{
  Kept,
  Moved,
  Removed
};

/// Makes a point keep the limits of angle, lambda and radius where that is possible.
Fate limited(const AxisGeometry& geometry, bool exactAngle, const Crossing& crossing,
  BisectorPoint& point)
{
  Fate fate = Fate::Kept;
  if (exactAngle && point.separationAngle() < geometry.angle)
  {
    const auto [from, to] = ends(geometry.frame, crossing);
    std::optional<BisectorPoint> other =
      facetedPoint(geometry, from, crossing.siteA, to, crossing.siteB);
    if (!other)
    {
      other = axisAlongNormal(geometry, point);
      fate = other ? Fate::Moved : Fate::Removed;
    }
    point = other.value_or(point);
  }
  const bool large =
    point.radius() >= std::max(geometry.radius, kLeastRadius) && point.lambda() >= geometry.lambda;
  return large ? fate : Fate::Removed;
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

} // namespace

BisectorPoint bisectorPoint(const AxisGeometry& geometry, const glm::dvec3& from, int fromSite,
  const glm::dvec3& to, int toSite)
{
  SiteChange change(geometry.sites, from, fromSite, to, toSite);
  for (int round = 1; round < kMaxRounds; ++round)
  {
    const SitePoint closest = geometry.query.closest(change.point().position, change.point().a);
    if (change.settledBy(closest))
    {
      break;
    }
    change.narrow(closest);
  }
  return change.point();
}

std::optional<BisectorPoint> axisAlongNormal(const AxisGeometry& geometry, const BisectorPoint& x)
{
  const double radius = x.radius();
  if (radius < kLeastRadius)
  {
    return std::nullopt;
  }
  const glm::dvec3 away = (x.position - x.a.point) / radius;
  const double step = glm::dot(glm::abs(away), geometry.frame.step);
  const double reach = step * (0.5 / std::sin(0.5 * geometry.angle) + 0.5);
  const glm::dvec3 end = x.position + reach * away;
  if (!insideGrid(geometry, end))
  {
    return std::nullopt;
  }
  const SitePoint other = geometry.query.closest(end, closestPoint(geometry.sites, x.a.site, end));
  if (separationAngle(end, end - away, other.point) < geometry.angle)
  {
    return std::nullopt;
  }
  return axisBetween(geometry, x.position, x.a.site, end, other.site);
}

BisectorPoints bisectorPoints(const AxisGeometry& geometry, bool exactAngle,
  std::vector<Crossing>& crossings)
{
  BisectorPoints result;
  result.points.resize(crossings.size());
  result.moved.resize(crossings.size());
  // Enough for several of most tiles.
  constexpr std::size_t kGrain = 512;
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, crossings.size(), kGrain),
    [&](const tbb::blocked_range<std::size_t>& range)
    {
      const std::vector<std::size_t> order = byTile(geometry.query, crossings, range);
      const std::vector<SiteChange> changes = settledChanges(geometry, crossings, order);
      for (std::size_t i = 0; i < order.size(); ++i)
      {
        const std::size_t c = order[i];
        result.points[c] = changes[i].point();
        result.moved[c] =
          static_cast<std::uint8_t>(limited(geometry, exactAngle, crossings[c], result.points[c]));
      }
    });
  std::size_t kept = 0;
  for (std::size_t i = 0; i < crossings.size(); ++i)
  {
    if (result.moved[i] != static_cast<std::uint8_t>(Fate::Removed))
    {
      crossings[kept] = crossings[i];
      result.points[kept] = result.points[i];
      result.moved[kept] = result.moved[i];
      ++kept;
    }
  }
  crossings.resize(kept);
  result.points.resize(kept);
  result.moved.resize(kept);
  return result;
}

} // namespace medial
