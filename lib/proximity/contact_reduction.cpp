#include "proximity/contact_reduction.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>
#include <utility>

namespace medial
{
namespace
{

struct Projected
{
  glm::dvec2 x;
  int place;
};

double cross(const glm::dvec2& a, const glm::dvec2& b)
{
  return a.x * b.y - a.y * b.x;
}

/// Whether a place beats another at the same position.
bool isDeeper(const ContactPlace& p, const ContactPlace& q)
{
  return p.isCrossing != q.isCrossing ? q.isCrossing : p.depth > q.depth;
}

/// Removes all but the best place of each position.
void mergeEqual(const std::vector<ContactPlace>& places, double tolerance,
  std::vector<Projected>& points)
{
  std::vector<Projected> kept;
  for (const Projected& point : points)
  {
    bool merged = false;
    // Sorted along x, so only the last ones can be near.
    for (std::size_t i = kept.size(); i-- > 0 && kept[i].x.x >= point.x.x - tolerance;)
    {
      if (std::abs(kept[i].x.y - point.x.y) <= tolerance)
      {
        kept[i].place =
          isDeeper(places[point.place], places[kept[i].place]) ? point.place : kept[i].place;
        merged = true;
        break;
      }
    }
    if (!merged)
    {
      kept.push_back(point);
    }
  }
  points = std::move(kept);
}

/// One half of the hull (Andrew's monotone chain), from the first point to the last.
template <typename Iterator>
void addChain(Iterator begin, Iterator end, double tolerance, std::vector<Projected>& hull)
{
  const std::size_t first = hull.size();
  for (Iterator point = begin; point != end; ++point)
  {
    while (hull.size() >= first + 2)
    {
      const glm::dvec2& p = hull[hull.size() - 2].x;
      const glm::dvec2 along = point->x - p;
      if (cross(along, hull.back().x - p) < -tolerance * glm::length(along))
      {
        break;
      }
      hull.pop_back();
    }
    hull.push_back(*point);
  }
  hull.pop_back(); // the other half begins with it
}

} // namespace

ContactPlane::ContactPlane(const glm::dvec3& normal)
{
  const glm::dvec3 size = glm::abs(normal);
  const glm::dvec3 axis = size.x <= size.y && size.x <= size.z
    ? glm::dvec3(1.0, 0.0, 0.0)
    : (size.y <= size.z ? glm::dvec3(0.0, 1.0, 0.0) : glm::dvec3(0.0, 0.0, 1.0));
  u_ = glm::normalize(glm::cross(normal, axis));
  v_ = glm::cross(normal, u_);
}

void keepHull(const ContactPlane& plane, double tolerance, std::vector<ContactPlace>& places)
{
  std::vector<Projected> points;
  for (std::size_t i = 0; i < places.size(); ++i)
  {
    points.push_back({ plane.project(places[i].point), static_cast<int>(i) });
  }
  std::sort(points.begin(), points.end(),
    [](const Projected& p, const Projected& q)
    { return std::tie(p.x.x, p.x.y, p.place) < std::tie(q.x.x, q.x.y, q.place); });
  mergeEqual(places, tolerance, points);
  std::vector<Projected> hull;
  if (points.size() > 2)
  {
    addChain(points.begin(), points.end(), tolerance, hull);
    addChain(points.rbegin(), points.rend(), tolerance, hull);
  }
  else
  {
    hull = points;
  }
  std::vector<ContactPlace> kept;
  for (const Projected& point : hull)
  {
    kept.push_back(places[point.place]);
  }
  places = std::move(kept);
}

void keepSpread(const ContactPlane& plane, int count, std::vector<ContactPlace>& places)
{
  const auto deepest = [](const ContactPlace& p, const ContactPlace& q)
  { return p.depth < q.depth; };
  if (places.empty())
  {
    return;
  }
  std::iter_swap(places.begin(), std::max_element(places.begin(), places.end(), deepest));
  const auto wanted = std::min(places.size(), static_cast<std::size_t>(count));
  std::vector<double> squared(places.size(), std::numeric_limits<double>::infinity());
  for (std::size_t next = 1; next < wanted; ++next)
  {
    std::size_t farthest = next;
    const glm::dvec2 last = plane.project(places[next - 1].point);
    for (std::size_t i = next; i < places.size(); ++i)
    {
      const glm::dvec2 gap = plane.project(places[i].point) - last;
      squared[i] = std::min(squared[i], glm::dot(gap, gap));
      farthest = squared[i] > squared[farthest] ? i : farthest;
    }
    std::swap(places[next], places[farthest]);
    std::swap(squared[next], squared[farthest]);
  }
  places.resize(wanted);
  std::stable_sort(places.begin(), places.end(),
    [](const ContactPlace& p, const ContactPlace& q) { return p.depth > q.depth; });
}

} // namespace medial
