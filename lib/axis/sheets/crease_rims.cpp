#include "axis/sheets/crease_rims.h"

#include "axis/sheets/sheet_band.h"
#include "axis/tile_order.h"

#include <algorithm>
#include <iterator>
#include <optional>

namespace medial
{
namespace
{

/// The balls of rims that end in a crease are smaller than this, in grid steps.
constexpr double kNearCrease = 2.0;
/// Such rims are no farther from the crease, in grid steps.
constexpr double kFarthest = 3.0;
/// Radius of the last ball, in grid steps.
constexpr double kLeft = 0.05;
/// Enough for separation angles up to 150 degrees.
constexpr int kMaxSteps = 16;
/// The shortest step that is tried, as a share of the longest that keeps balls overlapping.
constexpr double kShortest = 0.25;

/// Returns the vertices with small balls between different closest points.
std::vector<std::size_t> nearCreases(const AxisGeometry& geometry,
  const std::vector<std::size_t>& vertices, const BisectorPoints& points)
{
  std::vector<std::size_t> near;
  std::copy_if(vertices.begin(), vertices.end(), std::back_inserter(near),
    [&](std::size_t v)
    {
      const BisectorPoint& point = points.points[v];
      return point.radius() < kNearCrease && point.lambda() > 0.0 &&
        geometry.insideGrid(point.position);
    });
  return near;
}

/// Returns the smallest radius that the last ball of a point may have.
double minRadius(const AxisGeometry& geometry, const BisectorPoint& point)
{
  const double lambda = point.lambda();
  return std::max({ kLeft, geometry.limits.radius,
    lambda > 0.0 ? geometry.limits.lambda * point.radius() / lambda : 0.0 });
}

/// Returns a segment across the sheet at x, from the side of one closest point of the ball to that
/// of the other.
SiteSegment across(const BisectorPoint& ball, const glm::dvec3& x, double length)
{
  const glm::dvec3 half = 0.5 * length * glm::normalize(ball.a.point - ball.b.point);
  return { x + half, ball.a.site, x - half, ball.b.site };
}

/// Returns a segment across the sheet nearer to the crease, from one of the planes that touch the
/// ball to the other, with the sites of the ball. A smaller ball there still overlaps this one, so
/// that both are on the same side of the surface. Nothing if the planes do not meet nearby.
/// @param share of the longest step.
std::optional<SiteSegment> acrossNearerToCrease(const AxisGeometry& geometry,
  const BisectorPoint& point, double share)
{
  const double radius = point.radius();
  const glm::dvec3 toA = (point.a.point - point.position) / radius;
  const glm::dvec3 toB = (point.b.point - point.position) / radius;
  // The radius falls by this much per unit of length along the bisector of two planes.
  const double slope = 0.5 * glm::length(toA + toB);
  const double min = minRadius(geometry, point);
  constexpr double kOverlap = 1.1;
  constexpr double kThere = 1.1; // farther steps would change nothing
  const double longest = radius - std::max(min, kOverlap * (1.0 - slope) / (1.0 + slope) * radius);
  if (longest <= 0.0 || radius <= kThere * min || radius - min > kFarthest * slope)
  {
    return std::nullopt;
  }
  const double target = radius - share * longest;
  const glm::dvec3 x = point.position + 0.5 * (radius - target) / (slope * slope) * (toA + toB);
  return across(point, x, 0.7 * target);
}

bool overlap(const BisectorPoint& one, const BisectorPoint& other)
{
  return glm::distance(one.position, other.position) < one.radius() + other.radius();
}

/// Whether `next`, nearer to the crease than `point`, is on the same side of the surface and within
/// the limits.
bool continues(const AxisGeometry& geometry, const BisectorPoint& point, const BisectorPoint& next)
{
  constexpr double kRounding = 1e-6;
  const double radius = next.radius();
  return radius > 0.5 * kLeft && radius < point.radius() && overlap(point, next) &&
    radius >= geometry.limits.radius - kRounding &&
    next.lambda() >= geometry.limits.lambda - kRounding &&
    next.separationAngle() >= geometry.limits.angle;
}

/// A vertex on its way to a crease.
struct Walker
{
  std::size_t vertex;
  BisectorPoint point;
  double share = 1.0; ///< of the longest step, to be tried next
};

/// Moves the vertices exactly onto the bisector: a fitted vertex is only near it, and its second
/// closest point is that of a neighbour.
std::vector<Walker> start(const AxisGeometry& geometry, const std::vector<std::size_t>& vertices,
  const BisectorPoints& points)
{
  std::vector<SiteSegment> segments;
  for (const std::size_t v : vertices)
  {
    const BisectorPoint& point = points.points[v];
    segments.push_back(across(point, point.position, 0.7 * point.radius()));
  }
  const std::vector<std::optional<BisectorPoint>> found = bisectorsNear(geometry, segments);
  std::vector<Walker> walkers;
  for (std::size_t i = 0; i < vertices.size(); ++i)
  {
    if (found[i] && overlap(points.points[vertices[i]], *found[i]) &&
      found[i]->separationAngle() >= geometry.limits.angle)
    {
      walkers.push_back({ vertices[i], *found[i] });
    }
  }
  return walkers;
}

/// Takes one step towards the crease. Keeps the walkers that could, and those that are to try a
/// shorter one: where facets turn towards the crease, the planes of a ball lead past the bisector.
/// Rims whose angle is near the limit end in no crease.
void step(const AxisGeometry& geometry, std::vector<Walker>& walkers, BisectorPoints& points)
{
  std::vector<Walker> tried;
  std::vector<SiteSegment> segments;
  for (const Walker& walker : walkers)
  {
    if (const auto segment = acrossNearerToCrease(geometry, walker.point, walker.share))
    {
      tried.push_back(walker);
      segments.push_back(*segment);
    }
  }
  const std::vector<std::optional<BisectorPoint>> found = bisectorsNear(geometry, segments);
  const AngleLimit limit = clearLimit(geometry);
  walkers.clear();
  for (std::size_t i = 0; i < tried.size(); ++i)
  {
    const Walker& walker = tried[i];
    if (found[i] && continues(geometry, walker.point, *found[i]))
    {
      points.points[walker.vertex] = *found[i];
      walkers.push_back({ walker.vertex, *found[i] });
    }
    else if (!found[i] && walker.share > kShortest && walker.point.reaches(limit))
    {
      walkers.push_back({ walker.vertex, walker.point, 0.5 * walker.share });
    }
  }
}

} // namespace

void extendRims(const AxisGeometry& geometry, const std::vector<std::size_t>& vertices,
  BisectorPoints& points)
{
  const std::vector<std::size_t> rim = nearCreases(geometry, vertices, points);
  const std::vector<std::uint32_t> order = tileOrder(geometry.part, rim.size(),
    [&](std::size_t i) { return geometry.cellAt(points.points[rim[i]].position); });
  inBlocks(geometry, rim.size(),
    [&](std::size_t begin, std::size_t end)
    {
      std::vector<std::size_t> some;
      for (std::size_t k = begin; k != end; ++k)
      {
        some.push_back(rim[order[k]]);
      }
      std::vector<Walker> walkers = start(geometry, some, points);
      for (int i = 0; i < kMaxSteps && !walkers.empty(); ++i)
      {
        step(geometry, walkers, points);
      }
    });
}

} // namespace medial
