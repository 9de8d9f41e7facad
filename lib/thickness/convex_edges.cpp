#include "thickness/convex_edges.h"

#include "base/segment_distance.h"

#include <algorithm>
#include <cmath>

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
  std::vector<char> tips = sharp.points;
  for (const int edge : sharp.edges)
  {
    for (int end = 0; end < 2; ++end)
    {
      const int point = sites.edges()[edge][end];
      points_.push_back(sites.points()[point]);
      tips[point] = 0;
    }
  }
  for (std::size_t point = 0; point < tips.size(); ++point)
  {
    if (tips[point])
    {
      points_.insert(points_.end(), 2, sites.points()[point]);
    }
  }
  std::vector<glm::ivec3> ends;
  for (int first = 0; first < static_cast<int>(points_.size()); first += 2)
  {
    ends.emplace_back(first, first + 1, first + 1);
  }
  if (!ends.empty())
  {
    tree_.build(points_, ends);
  }
}

bool ConvexEdges::isNear(const glm::dvec3& x, double distance) const
{
  if (points_.empty())
  {
    return false;
  }
  const double limit = distance * distance;
  bool found = false;
  tree_.visitLeaves([&](const Box& box)
    { return !found && box.squaredDistance(x) <= limit * Box::kRoundedUp; },
    [&](const BoxTree::Node& leaf)
    {
      for (int slot = leaf.first; slot < leaf.first + leaf.count; ++slot)
      {
        const int first = 2 * tree_.elements()[slot];
        found = found || squaredDistanceToSegment(x, points_[first], points_[first + 1]) <= limit;
      }
    });
  return found;
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
