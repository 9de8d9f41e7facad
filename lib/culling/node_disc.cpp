#include "culling/node_disc.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace medial
{
namespace
{

/// Returns the axis of a disc around faces.
/// @param area sum of their normals, of lengths in proportion to their areas.
glm::dvec3 axisOf(const glm::dvec3& area)
{
  const double length = glm::length(area);
  return length > 0.0 ? area / length : glm::dvec3(0.0, 0.0, 1.0);
}

/// Returns a disc around parts.
/// @param visit calls its argument with the centre of every part, and how far the part extends
///   along the normal and across it.
template <typename Visit>
NodeDisc discAround(const glm::dvec3& n, const Visit& visit)
{
  NodeDisc disc;
  disc.normal = n;
  double low = std::numeric_limits<double>::max();
  double high = std::numeric_limits<double>::lowest();
  glm::dvec3 min(std::numeric_limits<double>::max());
  glm::dvec3 max(std::numeric_limits<double>::lowest());
  visit(
    [&](const glm::dvec3& point, double along, double across)
    {
      const double height = glm::dot(n, point);
      low = std::min(low, height - along);
      high = std::max(high, height + along);
      min = glm::min(min, point - across);
      max = glm::max(max, point + across);
    });
  const glm::dvec3 middle = 0.5 * (min + max);
  disc.centre = middle + (0.5 * (low + high) - glm::dot(n, middle)) * n;
  disc.halfHeight = 0.5 * (high - low);
  visit(
    [&](const glm::dvec3& point, double, double across)
    {
      const glm::dvec3 v = point - disc.centre;
      disc.radius = std::max(disc.radius, glm::length(v - glm::dot(v, n) * n) + across);
    });
  return disc;
}

/// Calls visit(point) for the corners of an element.
template <typename Visit>
void visitCorners(const SiteSet& sites, int element, const Visit& visit)
{
  switch (sites.kind(element))
  {
    case SiteKind::Face:
      for (int i = 0; i < 3; ++i)
      {
        visit(sites.points()[sites.faces()[element][i]]);
      }
      return;
    case SiteKind::Edge:
      visit(sites.points()[sites.edges()[element - sites.firstEdge()][0]]);
      visit(sites.points()[sites.edges()[element - sites.firstEdge()][1]]);
      return;
    case SiteKind::Vertex:
      visit(sites.points()[element - sites.firstVertex()]);
      return;
  }
}

NodeDisc discOf(const NodeDisc* discs, int count)
{
  glm::dvec3 area(0.0);
  for (int i = 0; i < count; ++i)
  {
    area += discs[i].normal * (discs[i].radius * discs[i].radius);
  }
  const glm::dvec3 n = axisOf(area);
  NodeDisc parent = discAround(n,
    [&](const auto& add)
    {
      for (int i = 0; i < count; ++i)
      {
        const NodeDisc& disc = discs[i];
        const double cosine = std::min(std::abs(glm::dot(n, disc.normal)), 1.0);
        const double sine = std::sqrt(1.0 - cosine * cosine);
        add(disc.centre, disc.radius * sine + disc.halfHeight * cosine,
          disc.radius + disc.halfHeight * sine);
      }
    });
  parent.cone = 0.0;
  for (int i = 0; i < count; ++i)
  {
    const double cosine = std::clamp(glm::dot(n, discs[i].normal), -1.0, 1.0);
    parent.cone = std::max(parent.cone, discs[i].cone + std::acos(cosine));
  }
  return parent;
}

/// Returns the slope of a cone, a little larger by rounding; infinite for wide ones.
float slopeOf(double cone)
{
  constexpr double kWide = 1.3;
  constexpr float kRounding = 1e-4f;
  return cone < kWide ? static_cast<float>(std::tan(cone)) * (1.0f + kRounding) + kRounding
                      : std::numeric_limits<float>::infinity();
}

void setDisc(Discs& discs, int lane, const NodeDisc& disc, float slack)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    discs.centre[axis][lane] = static_cast<float>(disc.centre[axis]);
    discs.normal[axis][lane] = static_cast<float>(disc.normal[axis]);
  }
  discs.radius[lane] = static_cast<float>(disc.radius) + slack;
  discs.halfHeight[lane] = static_cast<float>(disc.halfHeight) + slack;
  discs.slope[lane] = slopeOf(disc.cone);
}

} // namespace

NodeDisc discOf(const SiteSet& sites, const SharedSites& shared, const SiteGroup& group)
{
  glm::dvec3 area(0.0);
  for (const int element : group.elements)
  {
    if (sites.kind(element) == SiteKind::Face)
    {
      const glm::ivec3& face = sites.faces()[element];
      const glm::dvec3& a = sites.points()[face[0]];
      area += glm::cross(sites.points()[face[1]] - a, sites.points()[face[2]] - a);
    }
  }
  NodeDisc disc = discAround(axisOf(area),
    [&](const auto& add)
    {
      for (const int element : group.elements)
      {
        visitCorners(sites, element, [&](const glm::dvec3& point) { add(point, 0.0, 0.0); });
      }
    });
  const double cosine = shared.minCosine(sites, group, disc.normal);
  disc.cone = cosine > 0.0 ? std::acos(std::min(cosine, 1.0)) : NodeDisc::kNoCone;
  return disc;
}

std::vector<Discs> packed(std::vector<NodeDisc>& discs, float slack)
{
  std::vector<Discs> packs((discs.size() + kLanes - 1) / kLanes);
  std::vector<NodeDisc> parents(packs.size());
  tbb::parallel_for(std::size_t{ 0 }, packs.size(),
    [&](std::size_t i)
    {
      const NodeDisc* const first = discs.data() + i * kLanes;
      const int count = static_cast<int>(std::min<std::size_t>(kLanes, discs.size() - i * kLanes));
      packs[i].clear();
      for (int lane = 0; lane < count; ++lane)
      {
        setDisc(packs[i], lane, first[lane], slack);
      }
      parents[i] = discOf(first, count);
    });
  discs = std::move(parents);
  return packs;
}

} // namespace medial
