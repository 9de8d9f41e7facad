#include "medial/medial/crease_rims.h"

#include "medial/medial/medial_curves.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

namespace medial
{
namespace
{

/// Lengths in grid steps. Rims that end in a crease have smaller balls than this,
constexpr double kNearCrease = 2.0;
/// and are no farther from it.
constexpr double kFarthest = 3.0;
/// Radius that is left.
constexpr double kLeft = 0.05;
/// Enough for separation angles up to 150 degrees.
constexpr int kMostSteps = 8;

std::vector<std::size_t> rimVertices(const DualMesh& mesh, const BisectorPoints& points)
{
  AxisEdges edges;
  edges.sides.reserve(4 * mesh.quads.size());
  for (const auto& quad : mesh.quads)
  {
    for (std::size_t i = 0; i < 4; ++i)
    {
      edges.sides.push_back({ quad[i], quad[(i + 1) % 4] });
    }
  }
  const std::vector<AxisFeature> features = axisFeatures(edges, mesh.cells.size());
  std::vector<std::size_t> rim;
  for (std::size_t v = 0; v < features.size(); ++v)
  {
    if (features[v] == AxisFeature::Rim && points.points[v].radius() < kNearCrease)
    {
      rim.push_back(v);
    }
  }
  return rim;
}

/// The least radius that may be left at a point.
double leastRadius(const AxisGeometry& geometry, const BisectorPoint& point)
{
  const double lambda = point.lambda();
  return std::max(
    { kLeft, geometry.radius, lambda > 0.0 ? geometry.lambda * point.radius() / lambda : 0.0 });
}

/// Across the sheet nearer to the crease, from one of the planes that touch the ball to the other,
/// with the ball's sites: where a smaller ball still overlaps this one, so that both are on the same
/// side of the surface. Empty where the planes do not meet nearby.
std::optional<SiteSegment> acrossNearerToCrease(const AxisGeometry& geometry,
  const BisectorPoint& point)
{
  const double radius = point.radius();
  const glm::dvec3 toA = (point.a.point - point.position) / radius;
  const glm::dvec3 toB = (point.b.point - point.position) / radius;
  // By this much the radius falls per length along the bisector of two planes.
  const double slope = 0.5 * glm::length(toA + toB);
  const double least = leastRadius(geometry, point);
  constexpr double kOverlap = 1.1;
  const double target = std::max(least, kOverlap * (1.0 - slope) / (1.0 + slope) * radius);
  if (target >= radius || radius - least > kFarthest * slope)
  {
    return std::nullopt;
  }
  const glm::dvec3 x = point.position + 0.5 * (radius - target) / (slope * slope) * (toA + toB);
  const glm::dvec3 half = 0.25 * target * (toA - toB);
  const SiteSegment across{ x + half, point.a.site, x - half, point.b.site };
  return geometry.insideGrid(across.from) && geometry.insideGrid(across.to)
    ? std::optional(across)
    : std::nullopt;
}

/// Turns sites near the ends of segments into the closest ones.
void findSites(const AxisGeometry& geometry, std::vector<SiteSegment>& segments)
{
  std::vector<TileQuery::Question> questions;
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

/// Whether `next`, nearer to the crease than `point`, is on the same side of the surface and within
/// the limits.
bool continues(const AxisGeometry& geometry, const BisectorPoint& point, const BisectorPoint& next)
{
  constexpr double kRounding = 1e-6;
  const double radius = next.radius();
  return radius > 0.5 * kLeft && radius < point.radius() &&
    glm::distance(point.position, next.position) < point.radius() + radius &&
    radius >= geometry.radius - kRounding && next.lambda() >= geometry.lambda - kRounding &&
    next.separationAngle() >= geometry.angle;
}

/// Moves points one step towards their creases, and returns those that moved.
std::vector<std::size_t> moved(const AxisGeometry& geometry,
  const std::vector<std::size_t>& vertices, BisectorPoints& points)
{
  std::vector<std::size_t> tried;
  std::vector<SiteSegment> segments;
  for (const std::size_t v : vertices)
  {
    if (const auto segment = acrossNearerToCrease(geometry, points.points[v]))
    {
      tried.push_back(v);
      segments.push_back(*segment);
    }
  }
  findSites(geometry, segments);
  const std::vector<BisectorPoint> found = bisectorPoints(geometry, segments);
  std::vector<std::size_t> result;
  for (std::size_t i = 0; i < tried.size(); ++i)
  {
    BisectorPoint& point = points.points[tried[i]];
    if (segments[i].fromSite != segments[i].toSite && continues(geometry, point, found[i]))
    {
      point = found[i];
      result.push_back(tried[i]);
    }
  }
  return result;
}

} // namespace

void extendRims(const AxisGeometry& geometry, const DualMesh& mesh, BisectorPoints& points)
{
  const std::vector<std::size_t> rim = rimVertices(mesh, points);
  constexpr std::size_t kTogether = 512;
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, rim.size(), kTogether),
    [&](const tbb::blocked_range<std::size_t>& range)
    {
      std::vector<std::size_t> vertices(rim.begin() + static_cast<std::ptrdiff_t>(range.begin()),
        rim.begin() + static_cast<std::ptrdiff_t>(range.end()));
      for (int step = 0; step < kMostSteps && !vertices.empty(); ++step)
      {
        vertices = moved(geometry, vertices, points);
      }
    });
}

} // namespace medial
