#include "axis/bisector.h"

#include "axis/site_change.h"
#include "axis/tile_order.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace medial
{
namespace
{

/// Maximum number of sites that are looked for between the two.
constexpr int kMaxRounds = 8;

using Found = std::vector<std::optional<BisectorPoint>>;

bool wideEnough(const AxisGeometry& geometry, const BisectorPoint& point)
{
  return point.separationAngle() >= geometry.limits.angle;
}

/// Passes the items for which `wanted` holds to `find`, all at once, and stores the results.
template <typename Item, typename Wanted, typename Find>
void findFor(const std::vector<Item>& items, const Wanted& wanted, const Find& find, Found& found)
{
  std::vector<Item> some;
  std::vector<std::size_t> which;
  for (std::size_t i = 0; i < items.size(); ++i)
  {
    if (wanted(i))
    {
      some.push_back(items[i]);
      which.push_back(i);
    }
  }
  const Found foundForSome = find(some);
  for (std::size_t k = 0; k < which.size(); ++k)
  {
    found[which[k]] = foundForSome[k];
  }
}

/// Returns the point at equal distance from both sites if another site is nearer by no more than
/// the sag of facets.
std::optional<BisectorPoint> withinFacets(BisectorPoint point, const SitePoint& closest,
  double minAngle)
{
  if (glm::distance(closest.point, point.position) < point.radius() - kFacets)
  {
    return std::nullopt;
  }
  const SitePoint other = point.a;
  point.a = closest;
  if (separationAngle(point.position, closest.point, other.point) > point.separationAngle())
  {
    point.b = other;
  }
  return point.separationAngle() >= minAngle ? std::optional(point) : std::nullopt;
}

/// Returns the same point with one of the sites of the segment as the second closest.
std::optional<BisectorPoint> widened(const AxisGeometry& geometry, BisectorPoint point,
  const SiteSegment& segment)
{
  const glm::dvec3& x = point.position;
  for (const int site : { segment.fromSite, segment.toSite })
  {
    const SitePoint other = closestPoint(geometry.sites, site, x);
    if (glm::distance(other.point, x) <= point.radius() + kFacets &&
      separationAngle(x, point.a.point, other.point) >= geometry.limits.angle)
    {
      point.b = other;
      return point;
    }
  }
  return std::nullopt;
}

/// Finds points with the minimum separation angle on the segments.
Found axisBetween(const AxisGeometry& geometry, const std::vector<SiteSegment>& segments)
{
  const std::vector<BisectorPoint> exact = bisectorPoints(geometry, segments);
  Found found(exact.begin(), exact.end());
  const auto tooNarrow = [&](std::size_t i) { return !wideEnough(geometry, exact[i]); };
  findFor(
    segments, tooNarrow,
    [&](const auto& some) { return facetedPoints(geometry, some, geometry.limits.angle); }, found);
  for (std::size_t i = 0; i < segments.size(); ++i)
  {
    if (!found[i])
    {
      found[i] = widened(geometry, exact[i], segments[i]);
    }
  }
  return found;
}

/// Returns the segment from x away from its closest point, as far as the axis may be.
SiteSegment alongNormal(const AxisGeometry& geometry, const BisectorPoint& x)
{
  const glm::dvec3 away = (x.position - x.a.point) / x.radius();
  const double step = glm::dot(glm::abs(away), geometry.frame.step);
  const double reach = step * (0.5 / std::sin(0.5 * geometry.limits.angle) + 0.5);
  return { x.position, x.a.site, x.position + reach * away, -1 };
}

/// Replaces sites near the ends of segments by the closest ones.
void findSites(const AxisGeometry& geometry, std::vector<SiteSegment>& segments)
{
  std::vector<SiteQuery::Question> questions;
  for (const SiteSegment& segment : segments)
  {
    questions.push_back(
      { segment.from, closestPoint(geometry.sites, segment.fromSite, segment.from) });
    questions.push_back({ segment.to, closestPoint(geometry.sites, segment.toSite, segment.to) });
  }
  geometry.query.closest(questions);
  for (std::size_t i = 0; i < segments.size(); ++i)
  {
    segments[i].fromSite = questions[2 * i].closest.site;
    segments[i].toSite = questions[2 * i + 1].closest.site;
  }
}

/// Drops marked crossings and their points.
void removeMarked(std::vector<Crossing>& crossings, BisectorPoints& points)
{
  std::size_t kept = 0;
  for (std::size_t i = 0; i < crossings.size(); ++i)
  {
    if (points.moved[i] == 0)
    {
      crossings[kept] = crossings[i];
      points.points[kept] = points.points[i];
      points.moved[kept] = points.moved[i];
      ++kept;
    }
  }
  crossings.resize(kept);
  points.points.resize(kept);
  points.moved.resize(kept);
}

} // namespace

SiteQuery::Question questionAt(const BisectorPoint& point)
{
  const double toA = glm::distance(point.position, point.a.point);
  const double toB = glm::distance(point.position, point.b.point);
  const bool aFirst = toA < toB || (toA == toB && point.a.site <= point.b.site);
  return aFirst ? SiteQuery::Question{ point.position, point.a, point.b.site }
                : SiteQuery::Question{ point.position, point.b, point.a.site };
}

bool isClosestPair(const BisectorPoint& point, const SitePoint& closest)
{
  return glm::distance(closest.point, point.position) > point.radius() - kSameDistance;
}

SiteSegment segmentOf(const GridFrame& frame, const Crossing& crossing)
{
  const glm::dvec3 from = frame.sample(glm::dvec3(crossing.voxel));
  glm::dvec3 to = from;
  to[crossing.axis] += frame.step[crossing.axis];
  return { from, crossing.siteA, to, crossing.siteB };
}

bool isBeyondSurface(const AxisGeometry& geometry, const SiteSegment& segment,
  const BisectorPoint& point)
{
  const bool nearFrom =
    glm::distance(segment.from, point.position) < glm::distance(segment.to, point.position);
  return geometry.isAcross(nearFrom ? segment.from : segment.to, 0.0, point);
}

std::vector<BisectorPoint> bisectorPoints(const AxisGeometry& geometry,
  const std::vector<SiteSegment>& segments)
{
  std::vector<SiteChange> changes;
  changes.reserve(segments.size());
  for (const SiteSegment& segment : segments)
  {
    changes.emplace_back(geometry.sites, segment);
  }
  std::vector<std::size_t> open(segments.size());
  std::iota(open.begin(), open.end(), std::size_t{ 0 });
  std::vector<SiteQuery::Question> questions;
  for (int round = 1; round < kMaxRounds && !open.empty(); ++round)
  {
    questions.clear();
    for (const std::size_t i : open)
    {
      questions.push_back(questionAt(changes[i].point()));
    }
    geometry.query.closest(questions);
    std::size_t left = 0;
    for (std::size_t k = 0; k < open.size(); ++k)
    {
      if (!isClosestPair(changes[open[k]].point(), questions[k].closest))
      {
        changes[open[k]].narrow(questions[k].closest);
        open[left++] = open[k];
      }
    }
    open.resize(left);
  }
  std::vector<BisectorPoint> points(segments.size());
  std::transform(changes.begin(), changes.end(), points.begin(),
    [](const SiteChange& change) { return change.point(); });
  return points;
}

Found facetedPoints(const AxisGeometry& geometry, const std::vector<SiteSegment>& segments,
  double minAngle)
{
  Found points(segments.size());
  std::vector<SiteQuery::Question> questions;
  for (std::size_t i = 0; i < segments.size(); ++i)
  {
    const BisectorPoint point = SiteChange(geometry.sites, segments[i]).point();
    if (point.separationAngle() >= minAngle)
    {
      points[i] = point;
      questions.push_back(questionAt(point));
    }
  }
  geometry.query.closest(questions);
  auto question = questions.begin();
  for (std::optional<BisectorPoint>& point : points)
  {
    if (point)
    {
      point = withinFacets(*point, (question++)->closest, minAngle);
    }
  }
  return points;
}

Found bisectorsOn(const AxisGeometry& geometry, std::vector<SiteSegment> segments)
{
  findSites(geometry, segments);
  const std::vector<BisectorPoint> points = bisectorPoints(geometry, segments);
  Found found(points.size());
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    if (segments[i].fromSite != segments[i].toSite && geometry.insideGrid(segments[i].from) &&
      geometry.insideGrid(segments[i].to))
    {
      found[i] = points[i];
    }
  }
  return found;
}

std::vector<BisectorPoint> guessedBisectors(const AxisGeometry& geometry,
  const std::vector<SiteSegment>& segments, std::vector<std::size_t>& open)
{
  std::vector<SiteChange> changes;
  changes.reserve(segments.size());
  std::vector<SiteQuery::Question> questions;
  questions.reserve(segments.size());
  for (const SiteSegment& segment : segments)
  {
    changes.emplace_back(geometry.sites, segment);
    questions.push_back(questionAt(changes.back().point()));
  }
  geometry.query.closest(questions);
  std::vector<BisectorPoint> points(segments.size());
  open.clear();
  for (std::size_t i = 0; i < segments.size(); ++i)
  {
    if (changes[i].found() && isClosestPair(changes[i].point(), questions[i].closest))
    {
      points[i] = changes[i].point();
    }
    else
    {
      points[i] = { questions[i].x, questions[i].closest, questions[i].closest };
      open.push_back(i);
    }
  }
  return points;
}

Found bisectorsNear(const AxisGeometry& geometry, const std::vector<SiteSegment>& segments)
{
  Found found(segments.size());
  std::vector<SiteSegment> inside;
  std::vector<std::size_t> which;
  for (std::size_t i = 0; i < segments.size(); ++i)
  {
    if (geometry.insideGrid(segments[i].from) && geometry.insideGrid(segments[i].to))
    {
      inside.push_back(segments[i]);
      which.push_back(i);
    }
  }
  std::vector<std::size_t> open;
  const std::vector<BisectorPoint> guessed = guessedBisectors(geometry, inside, open);
  std::vector<SiteSegment> others;
  for (std::size_t k = 0; k < inside.size(); ++k)
  {
    found[which[k]] = guessed[k];
  }
  for (const std::size_t k : open)
  {
    others.push_back(inside[k]);
  }
  const Found foundForOthers = bisectorsOn(geometry, others);
  for (std::size_t k = 0; k < open.size(); ++k)
  {
    found[which[open[k]]] = foundForOthers[k];
  }
  return found;
}

Found axisAlongNormals(const AxisGeometry& geometry, const std::vector<BisectorPoint>& points)
{
  Found found(points.size());
  std::vector<SiteSegment> segments;
  std::vector<std::size_t> which;
  std::vector<SiteQuery::Question> ends;
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    if (points[i].radius() < kMinRadius)
    {
      continue;
    }
    const SiteSegment segment = alongNormal(geometry, points[i]);
    if (geometry.insideGrid(segment.to))
    {
      segments.push_back(segment);
      which.push_back(i);
      ends.push_back({ segment.to, closestPoint(geometry.sites, segment.fromSite, segment.to) });
    }
  }
  geometry.query.closest(ends);
  std::size_t count = 0;
  for (std::size_t k = 0; k < segments.size(); ++k)
  {
    SiteSegment& segment = segments[k];
    segment.toSite = ends[k].closest.site;
    if (separationAngle(segment.to, segment.from, ends[k].closest.point) >= geometry.limits.angle)
    {
      segments[count] = segment;
      which[count] = which[k];
      ++count;
    }
  }
  segments.resize(count);
  const Found between = axisBetween(geometry, segments);
  for (std::size_t k = 0; k < count; ++k)
  {
    const BisectorPoint& point = points[which[k]];
    if (between[k] && !geometry.isAcross(point.position, point.radius(), *between[k]))
    {
      found[which[k]] = between[k];
    }
  }
  return found;
}

BisectorPoints crossingPoints(const AxisGeometry& geometry, std::vector<Crossing>& crossings)
{
  BisectorPoints result;
  result.points.resize(crossings.size());
  result.moved.resize(crossings.size());
  const double minRadius = std::max(geometry.limits.radius, kMinRadius);
  const std::vector<std::uint32_t> order =
    tileOrder(geometry.part, crossings.size(), [&](std::size_t c) { return crossings[c].voxel; });
  inBlocks(geometry, crossings.size(),
    [&](std::size_t begin, std::size_t end)
    {
      std::vector<SiteSegment> segments(end - begin);
      for (std::size_t i = 0; i < segments.size(); ++i)
      {
        segments[i] = segmentOf(geometry.frame, crossings[order[begin + i]]);
      }
      const std::vector<BisectorPoint> points = bisectorPoints(geometry, segments);
      for (std::size_t i = 0; i < points.size(); ++i)
      {
        const bool stays = points[i].radius() >= minRadius &&
          points[i].lambda() >= geometry.limits.lambda &&
          !isBeyondSurface(geometry, segments[i], points[i]);
        const std::size_t c = order[begin + i];
        result.moved[c] = stays ? 0 : 1;
        result.points[c] = points[i];
      }
    });
  removeMarked(crossings, result);
  return result;
}

std::vector<SiteQuery::Question> closestToMiddles(const AxisGeometry& geometry,
  const std::vector<BisectorPoint>& points, const std::array<std::uint32_t, 2>* begin,
  const std::array<std::uint32_t, 2>* end)
{
  std::vector<SiteQuery::Question> questions;
  for (const auto* pair = begin; pair != end; ++pair)
  {
    const BisectorPoint& p = points[(*pair)[0]];
    const glm::dvec3 x = 0.5 * (p.position + points[(*pair)[1]].position);
    questions.push_back({ x, closestPoint(geometry.sites, p.a.site, x) });
  }
  geometry.query.closest(questions);
  return questions;
}

} // namespace medial
