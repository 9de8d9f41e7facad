#include "proximity/contact_reduction.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <tuple>
#include <utility>

namespace medial
{
namespace
{

double cross(const glm::dvec2& a, const glm::dvec2& b)
{
  return a.x * b.y - a.y * b.x;
}

double distanceToSegment(const glm::dvec2& x, const glm::dvec2& from, const glm::dvec2& to)
{
  const glm::dvec2 along = to - from;
  const double squared = glm::dot(along, along);
  const double t = squared > 0.0 ? std::clamp(glm::dot(x - from, along) / squared, 0.0, 1.0) : 0.0;
  return glm::distance(x, from + t * along);
}

/// Whether a place beats another at the same position.
bool isDeeper(const ContactPlace& p, const ContactPlace& q)
{
  return p.isCrossing != q.isCrossing ? q.isCrossing : p.depth > q.depth;
}

} // namespace

ContactPlane::ContactPlane(const glm::dvec3& normal, const glm::dvec3& origin)
  : origin_(origin)
{
  const glm::dvec3 size = glm::abs(normal);
  const glm::dvec3 axis = size.x <= size.y && size.x <= size.z
    ? glm::dvec3(1.0, 0.0, 0.0)
    : (size.y <= size.z ? glm::dvec3(0.0, 1.0, 0.0) : glm::dvec3(0.0, 0.0, 1.0));
  u_ = glm::normalize(glm::cross(normal, axis));
  v_ = glm::cross(normal, u_);
}

void ContactReduction::mergeEqual(const std::vector<ContactPlace>& places, double tolerance)
{
  std::size_t kept = 0;
  for (const Projected point : points_)
  {
    bool merged = false;
    // Sorted along x, so only the last ones can be near.
    for (std::size_t i = kept; i-- > 0 && points_[i].x.x >= point.x.x - tolerance;)
    {
      if (std::abs(points_[i].x.y - point.x.y) <= tolerance)
      {
        points_[i].place =
          isDeeper(places[point.place], places[points_[i].place]) ? point.place : points_[i].place;
        merged = true;
        break;
      }
    }
    if (!merged)
    {
      points_[kept++] = point;
    }
  }
  points_.resize(kept);
}

template <typename Iterator>
void ContactReduction::addChain(Iterator begin, Iterator end)
{
  const std::size_t first = hull_.size();
  for (Iterator point = begin; point != end; ++point)
  {
    while (hull_.size() >= first + 2)
    {
      const glm::dvec2& p = hull_[hull_.size() - 2].x;
      if (cross(point->x - p, hull_.back().x - p) < 0.0)
      {
        break;
      }
      hull_.pop_back();
    }
    hull_.push_back(*point);
  }
  hull_.pop_back(); // the other half begins with it
}

void ContactReduction::dropFlatCorners(double tolerance)
{
  // Only now: along an edge across the order of points, rounding shuffles them, so a chain may
  // begin at any of them and cannot tell yet which are its corners.
  std::size_t i = 0;
  while (i < hull_.size() && hull_.size() > 2)
  {
    const glm::dvec2& last = hull_[i == 0 ? hull_.size() - 1 : i - 1].x;
    const glm::dvec2& next = hull_[(i + 1) % hull_.size()].x;
    if (distanceToSegment(hull_[i].x, last, next) > tolerance)
    {
      ++i;
      continue;
    }
    hull_.erase(hull_.begin() + static_cast<std::ptrdiff_t>(i));
    i -= i > 0 ? 1 : 0; // the corner before has another neighbour
  }
}

void ContactReduction::keepHull(const ContactPlane& plane, double tolerance,
  std::vector<ContactPlace>& places)
{
  points_.clear();
  for (std::size_t i = 0; i < places.size(); ++i)
  {
    points_.push_back({ plane.project(places[i].point), static_cast<int>(i) });
  }
  std::sort(points_.begin(), points_.end(),
    [](const Projected& p, const Projected& q)
    { return std::tie(p.x.x, p.x.y, p.place) < std::tie(q.x.x, q.x.y, q.place); });
  this->mergeEqual(places, tolerance);
  hull_.clear();
  if (points_.size() > 2)
  {
    this->addChain(points_.begin(), points_.end());
    this->addChain(points_.rbegin(), points_.rend());
    this->dropFlatCorners(tolerance);
  }
  else
  {
    hull_ = points_;
  }
  kept_.clear();
  for (const Projected& point : hull_)
  {
    kept_.push_back(places[point.place]);
  }
  places = kept_;
}

void ContactReduction::keepSpread(const ContactPlane& plane, int count,
  std::vector<ContactPlace>& places)
{
  const auto deepest = [](const ContactPlace& p, const ContactPlace& q)
  { return p.depth < q.depth; };
  if (places.empty())
  {
    return;
  }
  std::iter_swap(places.begin(), std::max_element(places.begin(), places.end(), deepest));
  const auto wanted = std::min(places.size(), static_cast<std::size_t>(count));
  squared_.assign(places.size(), std::numeric_limits<double>::infinity());
  for (std::size_t next = 1; next < wanted; ++next)
  {
    std::size_t farthest = next;
    const glm::dvec2 last = plane.project(places[next - 1].point);
    for (std::size_t i = next; i < places.size(); ++i)
    {
      const glm::dvec2 gap = plane.project(places[i].point) - last;
      squared_[i] = std::min(squared_[i], glm::dot(gap, gap));
      farthest = squared_[i] > squared_[farthest] ? i : farthest;
    }
    std::swap(places[next], places[farthest]);
    std::swap(squared_[next], squared_[farthest]);
  }
  places.resize(wanted);
  // Equal ones stay in their order. std::stable_sort() would allocate.
  for (auto next = places.begin(); next != places.end(); ++next)
  {
    std::rotate(std::upper_bound(places.begin(), next, *next,
                  [](const ContactPlace& p, const ContactPlace& q) { return p.depth > q.depth; }),
      next, next + 1);
  }
}

} // namespace medial
