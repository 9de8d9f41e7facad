#include "support/local_thickness_oracle.h"

#include "support/point_math.h"

#include <algorithm>
#include <cmath>
#include <queue>

namespace medial::test
{
namespace
{

/// A box of centres and an upper bound of their radii.
struct Candidate
{
  Point3 centre;
  Point3 half;
  double bound;

  bool operator<(const Candidate& other) const { return bound < other.bound; }
};

/// Largest radius of a ball whose distance from the point is at most `outside`.
double largestRadius(const MeshSearch& search, const Bounds& centres, const Point3& point,
  double outside, double tolerance)
{
  double best = search.closest(point).distance;
  std::priority_queue<Candidate> queue;
  const auto add = [&](const Point3& centre, const Point3& half)
  {
    const double reach = std::hypot(half[0], half[1], half[2]);
    const double radius = search.closest(centre).distance;
    const double away = distance(centre, point);
    if (away <= radius + outside)
    {
      best = std::max(best, radius);
    }
    if (radius + reach > best + tolerance && away - reach <= radius + reach + outside)
    {
      queue.push({ centre, half, radius + reach });
    }
  };
  Point3 middle;
  Point3 half;
  for (int axis = 0; axis < 3; ++axis)
  {
    middle[axis] = 0.5 * (centres.min[axis] + centres.max[axis]);
    half[axis] = 0.5 * (centres.max[axis] - centres.min[axis]);
  }
  add(middle, half);
  while (!queue.empty() && queue.top().bound > best + tolerance)
  {
    const Candidate next = queue.top();
    queue.pop();
    const Point3 part{ 0.5 * next.half[0], 0.5 * next.half[1], 0.5 * next.half[2] };
    for (int corner = 0; corner < 8; ++corner)
    {
      Point3 centre = next.centre;
      for (int axis = 0; axis < 3; ++axis)
      {
        centre[axis] += (corner >> axis & 1) != 0 ? part[axis] : -part[axis];
      }
      add(centre, part);
    }
  }
  return best;
}

} // namespace

DiameterBounds largestBallAround(const MeshSearch& search, const Bounds& centres,
  const Point3& point, double slack, double tolerance)
{
  return { 2.0 * largestRadius(search, centres, point, -slack, 0.5 * tolerance),
    2.0 * largestRadius(search, centres, point, slack, 0.5 * tolerance) };
}

} // namespace medial::test
