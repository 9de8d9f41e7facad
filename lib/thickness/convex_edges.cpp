#include "thickness/convex_edges.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace medial
{
namespace
{

/// Planes at a smaller angle, degrees, are the two sides of a wall.
constexpr double kMinWedge = 15.0;
/// Planes at a larger angle are no opposite walls, whatever the edge between them looks like.
constexpr double kMaxWedge = 60.0;
/// How far the edge may be from where the planes meet, as a share of the way there.
constexpr double kReach = 0.25;

} // namespace

ConvexEdges::ConvexEdges(const SiteSet& sites, const SharpFeatures& sharp)
{
  std::vector<glm::dvec3> points;
  std::vector<char> tips = sharp.points;
  for (const int edge : sharp.edges)
  {
    for (int end = 0; end < 2; ++end)
    {
      const int point = sites.edges()[edge][end];
      points.push_back(sites.points()[point]);
      tips[point] = 0;
    }
  }
  for (std::size_t point = 0; point < tips.size(); ++point)
  {
    if (tips[point])
    {
      points.insert(points.end(), 2, sites.points()[point]);
    }
  }
  segments_.build(std::move(points));
}

bool ConvexEdges::isNear(const glm::dvec3& x, double distance) const
{
  return segments_.isNear(x, distance, [](int) { return true; });
}

bool isExplainedByEdge(const glm::dvec3& place, const glm::dvec3& normal,
  const glm::dvec3& opposite, const glm::dvec3& oppositeNormal, SurfaceAnswers& surface)
{
  const double cosine = glm::dot(normal, oppositeNormal);
  const glm::dvec3 rest = oppositeNormal - cosine * normal;
  const double sine = glm::length(rest);
  const double wedge = glm::degrees(std::atan2(sine, -cosine));
  if (wedge < kMinWedge || wedge > kMaxWedge)
  {
    return wedge > kMaxWedge;
  }
  // The planes' common line, where it is nearest to the place.
  const double way = glm::dot(oppositeNormal, opposite - place) / sine;
  return surface.nearConvexEdge(place + way / sine * rest, kReach * std::abs(way));
}

} // namespace medial
