#include "sites/closest_point.h"

#include <limits>

namespace medial
{
namespace
{

SitePoint closestOnEdge(const SiteSet& sites, int edge, const glm::dvec3& x)
{
  const glm::ivec2& ends = sites.edges()[edge];
  const glm::dvec3& p = sites.points()[ends[0]];
  const glm::dvec3& q = sites.points()[ends[1]];
  const glm::dvec3 along = q - p;
  const double t = glm::dot(x - p, along) / glm::dot(along, along);
  // Not a number where rounding has made the ends one point.
  if (!(t > 0.0))
  {
    return { sites.firstVertex() + ends[0], p };
  }
  if (t >= 1.0)
  {
    return { sites.firstVertex() + ends[1], q };
  }
  return { sites.firstEdge() + edge, p + t * along };
}

double squaredDistance(const glm::dvec3& a, const glm::dvec3& b)
{
  return glm::dot(a - b, a - b);
}

SitePoint closestOnFace(const SiteSet& sites, int face, const glm::dvec3& x)
{
  const glm::ivec3& corners = sites.faces()[face];
  const glm::dvec3& normal = sites.faceNormal(face);
  // Of a point beside the face, the closest is on an edge that has it outside.
  bool outside[3] = { true, true, true };
  if (sites.active(face))
  {
    for (int i = 0; i < 3; ++i)
    {
      const glm::dvec3& a = sites.points()[corners[i]];
      const glm::dvec3& b = sites.points()[corners[(i + 1) % 3]];
      outside[i] = !(glm::dot(glm::cross(b - a, normal), x - a) < 0.0);
    }
    if (!outside[0] && !outside[1] && !outside[2])
    {
      const glm::dvec3& a = sites.points()[corners[0]];
      return { face, x - glm::dot(x - a, normal) * normal };
    }
  }
  // The other two edges of a face without area cover the longest.
  const int covered = normal == glm::dvec3(0.0) ? sites.longestEdge(face) : -1;
  SitePoint best;
  double min = std::numeric_limits<double>::infinity();
  for (int i = 0; i < 3; ++i)
  {
    if (!outside[i] || i == covered)
    {
      continue;
    }
    const SitePoint other = closestOnEdge(sites, sites.faceEdges()[face][i], x);
    const double squared = squaredDistance(other.point, x);
    if (squared < min)
    {
      min = squared;
      best = other;
    }
  }
  return best;
}

} // namespace

SitePoint closestPoint(const SiteSet& sites, int site, const glm::dvec3& x)
{
  switch (sites.kind(site))
  {
    case SiteKind::Face:
      return closestOnFace(sites, site, x);
    case SiteKind::Edge:
      return closestOnEdge(sites, site - sites.firstEdge(), x);
    case SiteKind::Vertex:
      break;
  }
  return { site, sites.points()[site - sites.firstVertex()] };
}

} // namespace medial
