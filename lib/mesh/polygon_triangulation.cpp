#include "mesh/polygon_triangulation.h"

#include "medial/error.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <string>
#include <utility>

namespace medial
{

namespace
{

using Triangles = std::vector<std::array<int, 3>>;

/// Twice the area of an ear, divided by the square of its longest edge. Ears below this are clipped
/// only if there is no better one.
constexpr double kFlatEar = 1e-6;
/// A corner this near to an edge of an ear, relative to the size of the polygon, counts as on it:
/// rounded coordinates seldom lie on a line, and an edge that just misses a corner ends in
/// overlaps.
constexpr double kTouching = 1e-9;

/// Returns the corners relative to the first one and scaled to unit size, so that no product leaves
/// the range of double.
std::vector<glm::dvec3> normalised(const std::vector<Point3>& corners)
{
  const glm::dvec3 first(corners[0][0], corners[0][1], corners[0][2]);
  std::vector<glm::dvec3> result;
  result.reserve(corners.size());
  double size = 0.0;
  for (const Point3& corner : corners)
  {
    result.push_back(glm::dvec3(corner[0], corner[1], corner[2]) - first);
    const glm::dvec3 extent = glm::abs(result.back());
    size = std::max({ size, extent.x, extent.y, extent.z });
  }
  for (glm::dvec3& corner : result)
  {
    corner /= size > 0.0 ? size : 1.0;
  }
  return result;
}

glm::dvec3 newellNormal(const std::vector<glm::dvec3>& corners)
{
  glm::dvec3 normal(0.0);
  for (std::size_t i = 0; i < corners.size(); ++i)
  {
    normal += glm::cross(corners[i], corners[(i + 1) % corners.size()]);
  }
  return normal;
}

/// Drops the main axis of the normal, since this loses no precision. The result is anticlockwise.
std::vector<glm::dvec2> project(const std::vector<glm::dvec3>& corners, const glm::dvec3& normal)
{
  const glm::dvec3 size = glm::abs(normal);
  const int axis = size.x >= size.y && size.x >= size.z ? 0 : (size.y >= size.z ? 1 : 2);
  const int u = (axis + (normal[axis] > 0.0 ? 1 : 2)) % 3;
  const int v = 3 - axis - u;
  std::vector<glm::dvec2> result;
  result.reserve(corners.size());
  for (const glm::dvec3& corner : corners)
  {
    result.emplace_back(corner[u], corner[v]);
  }
  return result;
}

/// Returns twice the signed area of a triangle.
double turn(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c)
{
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// Returns twice the signed area, divided by the square of the longest edge.
double shape(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c)
{
  const double longest =
    std::max({ glm::dot(b - a, b - a), glm::dot(c - b, c - b), glm::dot(a - c, a - c) });
  return longest > 0.0 ? turn(a, b, c) / longest : 0.0;
}

/// Clips ears from a ring of corners. Each search starts behind the neighbour of the last ear,
/// which keeps the number of triangles around each corner low.
class EarClipper
{
public:
  EarClipper(const std::vector<glm::dvec2>& points, TriangulationEffort& effort)
    : points_(points)
    , effort_(effort)
    , previous_(points.size())
    , next_(points.size())
    , shapes_(points.size())
    , places_(points.size(), kNowhere)
    , blockers_(points.size(), std::array<int, 2>{ kNowhere, kNowhere })
  {
    const int count = static_cast<int>(points.size());
    for (int i = 0; i < count; ++i)
    {
      previous_[i] = (i + count - 1) % count;
      next_[i] = (i + 1) % count;
    }
    for (int i = 0; i < count; ++i)
    {
      shapes_[i] = shapeAt(i);
      updateObstacle(i);
    }
  }

  Triangles run()
  {
    Triangles triangles;
    int corner = 0;
    for (int left = static_cast<int>(points_.size()); left > 2; --left)
    {
      const int ear = findEar(corner, left);
      triangles.push_back({ previous_[ear], ear, next_[ear] });
      corner = next_[next_[ear]];
      remove(ear);
    }
    return triangles;
  }

private:
  double shapeAt(int i) const
  {
    return shape(points_[previous_[i]], points_[i], points_[next_[i]]);
  }

  /// Returns the first good ear, otherwise a flat one, otherwise (for a polygon that is not simple)
  /// any convex corner.
  int findEar(int start, int left)
  {
    for (const bool careful : { true, false })
    {
      effort_.spend(left);
      for (int i = 0, corner = start; i < left; ++i, corner = next_[corner])
      {
        if (shapes_[corner] > (careful ? kFlatEar : 0.0) && isFree(corner, careful))
        {
          return corner;
        }
      }
    }
    int best = start;
    for (int i = 0, corner = start; i < left; ++i, corner = next_[corner])
    {
      best = shapes_[corner] > shapes_[best] ? corner : best;
    }
    return best;
  }

  /// Whether no flat or reflex corner lies in the ear, or near it where that is asked for. What was
  /// in the way before is tried first: mostly it still is.
  bool isFree(int ear, bool careful)
  {
    int& blocker = blockers_[ear][careful ? 1 : 0];
    const double margin = careful ? kTouching : 0.0;
    if (blocker != kNowhere && places_[blocker] != kNowhere && blocks(blocker, ear, margin))
    {
      return false;
    }
    effort_.spend(static_cast<std::int64_t>(obstacles_.size()));
    const auto found = std::find_if(obstacles_.begin(), obstacles_.end(),
      [&](int obstacle) { return blocks(obstacle, ear, margin); });
    blocker = found == obstacles_.end() ? kNowhere : *found;
    return found == obstacles_.end();
  }

  /// Whether a corner lies in an ear or closer to it than `margin`. A corner at the same place as
  /// one of the ear is no obstacle: polygons with holes visit the ends of their bridges twice.
  bool blocks(int obstacle, int ear, double margin) const
  {
    const glm::dvec2& a = points_[previous_[ear]];
    const glm::dvec2& b = points_[ear];
    const glm::dvec2& c = points_[next_[ear]];
    const glm::dvec2& p = points_[obstacle];
    return p != a && p != b && p != c && turn(a, b, p) >= -margin * glm::distance(a, b) &&
      turn(b, c, p) >= -margin * glm::distance(b, c) &&
      turn(c, a, p) >= -margin * glm::distance(c, a);
  }

  void remove(int ear)
  {
    const int before = previous_[ear];
    const int after = next_[ear];
    next_[before] = after;
    previous_[after] = before;
    shapes_[before] = shapeAt(before);
    shapes_[after] = shapeAt(after);
    eraseObstacle(ear);
    updateObstacle(before);
    updateObstacle(after);
  }

  /// Makes a corner an obstacle, or none, by its shape. Their order does not matter.
  void updateObstacle(int corner)
  {
    eraseObstacle(corner);
    if (shapes_[corner] <= kFlatEar)
    {
      places_[corner] = static_cast<int>(obstacles_.size());
      obstacles_.push_back(corner);
    }
  }

  void eraseObstacle(int corner)
  {
    const int place = places_[corner];
    if (place != kNowhere)
    {
      obstacles_[place] = obstacles_.back();
      places_[obstacles_[place]] = place;
      obstacles_.pop_back();
      places_[corner] = kNowhere;
    }
  }

  static constexpr int kNowhere = -1;

  const std::vector<glm::dvec2>& points_;
  TriangulationEffort& effort_;
  std::vector<int> previous_;
  std::vector<int> next_;
  std::vector<double> shapes_;
  std::vector<int> obstacles_;               ///< corners that are flat or reflex
  std::vector<int> places_;                  ///< of every corner among the obstacles
  std::vector<std::array<int, 2>> blockers_; ///< of every ear, an obstacle found in or near it
};

Triangles splitQuad(const std::vector<glm::dvec2>& q)
{
  const double along02 = std::min(shape(q[0], q[1], q[2]), shape(q[0], q[2], q[3]));
  const double along13 = std::min(shape(q[1], q[2], q[3]), shape(q[1], q[3], q[0]));
  const bool shorter13 = glm::distance(q[1], q[3]) < glm::distance(q[0], q[2]);
  const bool bothValid = along02 > kFlatEar && along13 > kFlatEar;
  if (bothValid ? shorter13 : along13 > along02)
  {
    return { { 1, 2, 3 }, { 1, 3, 0 } };
  }
  return { { 0, 1, 2 }, { 0, 2, 3 } };
}

/// Returns the corners from the lowest position on, and on towards the lower of its neighbours.
std::vector<int> canonicalOrder(const std::vector<Point3>& corners)
{
  const int count = static_cast<int>(corners.size());
  const int first =
    static_cast<int>(std::min_element(corners.begin(), corners.end()) - corners.begin());
  const bool forwards = corners[(first + 1) % count] < corners[(first + count - 1) % count];
  std::vector<int> order;
  for (int i = 0; i < count; ++i)
  {
    order.push_back((first + (forwards ? i : count - i)) % count);
  }
  return order;
}

Triangles fan(int count)
{
  Triangles triangles;
  for (int i = 2; i < count; ++i)
  {
    triangles.push_back({ 0, i - 1, i });
  }
  return triangles;
}

} // namespace

void TriangulationEffort::spend(std::int64_t steps)
{
  constexpr std::size_t kFew = 1000;
  left_ -= corners_ > kFew ? steps : 0;
  if (left_ < 0)
  {
    throw Error(ErrorCode::InvalidInput,
      "a polygon of " + std::to_string(corners_) +
        " corners takes too long to be split into triangles");
  }
}

Triangles triangulatePolygon(const std::vector<Point3>& corners, TriangulationEffort& effort)
{
  effort.begin(corners.size());
  const int count = static_cast<int>(corners.size());
  if (count <= 3)
  {
    return fan(count);
  }
  const std::vector<int> order = canonicalOrder(corners);
  std::vector<Point3> ordered;
  std::transform(order.begin(), order.end(), std::back_inserter(ordered),
    [&](int corner) { return corners[corner]; });
  const std::vector<glm::dvec3> scaled = normalised(ordered);
  const glm::dvec3 normal = newellNormal(scaled);
  if (glm::dot(normal, normal) == 0.0)
  {
    return fan(count);
  }
  const std::vector<glm::dvec2> points = project(scaled, normal);
  Triangles triangles = count == 4 ? splitQuad(points) : EarClipper(points, effort).run();
  const bool isReversed = (order[0] + 1) % count != order[1];
  for (std::array<int, 3>& triangle : triangles)
  {
    for (int& corner : triangle)
    {
      corner = order[corner];
    }
    if (isReversed)
    {
      std::swap(triangle[1], triangle[2]);
    }
  }
  return triangles;
}

} // namespace medial
