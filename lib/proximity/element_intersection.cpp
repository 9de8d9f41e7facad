#include "proximity/element_intersection.h"

#include "base/exact_sign.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace medial
{
namespace
{

using Corners = std::array<glm::dvec3, 3>;

/// The sides of an element's corners of the plane of another one; all 0 if that one has no plane.
using Sides = std::array<int, 3>;

Sides sidesOf(const Corners& corners, const Corners& plane)
{
  const SidesOfPlane sides(plane[0], plane[1], plane[2]);
  return { sides.side(corners[0]), sides.side(corners[1]), sides.side(corners[2]) };
}

bool haveOneSign(const Sides& sides)
{
  return sides[0] != 0 && sides[0] == sides[1] && sides[0] == sides[2];
}

bool areZero(const Sides& sides)
{
  return sides[0] == 0 && sides[1] == 0 && sides[2] == 0;
}

/// Returns the corner whose two edges cross the plane in a point each. The sides are not all equal.
int apexOf(const Sides& sides)
{
  for (int i = 0; i < 3; ++i)
  {
    const int next = sides[(i + 1) % 3];
    const int last = sides[(i + 2) % 3];
    // Alone on its side, or alone in the plane.
    if ((sides[i] != 0 && next != sides[i] && last != sides[i]) || (sides[i] == 0 && next == last))
    {
      return i;
    }
  }
  return 0;
}

Corners turned(const Corners& corners, int first)
{
  return { corners[first], corners[(first + 1) % 3], corners[(first + 2) % 3] };
}

/// Whether the apex lies before the plane, where sides are negative, or in it and the rest behind.
bool liesBefore(const Sides& sides, int apex)
{
  return sides[apex] != 0 ? sides[apex] < 0 : sides[(apex + 1) % 3] > 0;
}

/// Whether two triangles overlap on the line in which their planes meet (Guigue and Devillers
/// 2003). Each meets the line in an interval between the two edges of its apex.
bool overlapOnCommonLine(const Corners& a, const Sides& sidesOfA, const Corners& b,
  const Sides& sidesOfB)
{
  const int apexOfA = apexOf(sidesOfA);
  const int apexOfB = apexOf(sidesOfB);
  Corners first = turned(a, apexOfA);
  Corners second = turned(b, apexOfB);
  // Turned over until either apex lies before the other plane.
  if (!liesBefore(sidesOfA, apexOfA))
  {
    std::swap(second[1], second[2]);
  }
  if (!liesBefore(sidesOfB, apexOfB))
  {
    std::swap(first[1], first[2]);
  }
  return orientation(first[0], first[1], second[0], second[1]) >= 0 &&
    orientation(first[0], first[2], second[0], second[2]) <= 0;
}

// What follows is for elements in one plane and for those without area.

/// The order of points along a line, whatever its direction.
bool isBefore(const glm::dvec3& p, const glm::dvec3& q)
{
  return p.x != q.x ? p.x < q.x : p.y != q.y ? p.y < q.y : p.z < q.z;
}

/// Coordinates of a point without the one along an axis.
glm::dvec2 projected(const glm::dvec3& point, int axis)
{
  return { point[(axis + 1) % 3], point[(axis + 2) % 3] };
}

/// Returns the axis along which three points are projected to a triangle with an area, or -1 if
/// they are collinear.
int projectionAxis(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    if (orientation(projected(a, axis), projected(b, axis), projected(c, axis)) != 0)
    {
      return axis;
    }
  }
  return -1;
}

/// The extreme points of an element.
struct Hull
{
  explicit Hull(const Corners& corners)
    : points(corners)
    , axis(projectionAxis(corners[0], corners[1], corners[2]))
  {
    if (axis < 0)
    {
      std::sort(points.begin(), points.end(), isBefore);
      points[1] = points[2];
      count = points[0] == points[1] ? 1 : 2;
    }
  }

  bool hasArea() const { return count == 3; }

  Corners points; ///< of which the first `count` count; the end of a segment is repeated
  int count = 3;
  int axis; ///< along which the projection has an area; -1 for segments and points
};

/// Whether an edge of one hull has all of the other strictly on a side where that one has nothing.
/// Nothing is strictly on a side of a point's only edge.
bool edgesSeparate(const Hull& a, const Hull& b, int axis)
{
  for (int i = 0; i < a.count; ++i)
  {
    const glm::dvec2 from = projected(a.points[i], axis);
    const glm::dvec2 to = projected(a.points[(i + 1) % a.count], axis);
    const auto side = [&](const glm::dvec3& point)
    { return orientation(from, to, projected(point, axis)); };
    const int other = side(b.points[0]);
    const auto isBeyond = [&](const glm::dvec3& point) { return side(point) == other; };
    if (other != 0 && std::all_of(b.points.begin() + 1, b.points.begin() + b.count, isBeyond) &&
      side(a.points[(i + 2) % a.count]) != other)
    {
      return true;
    }
  }
  return false;
}

/// Returns the axis along which the plane of both hulls is projected to a plane, or -1 if all
/// points are collinear.
int commonAxis(const Hull& a, const Hull& b)
{
  const int axis = std::max(a.axis, b.axis);
  if (axis >= 0)
  {
    return axis;
  }
  const std::array<std::array<glm::dvec3, 3>, 4> triples = { {
    { a.points[0], a.points[1], b.points[0] },
    { a.points[0], a.points[1], b.points[1] },
    { b.points[0], b.points[1], a.points[0] },
    { b.points[0], b.points[1], a.points[1] },
  } };
  for (const auto& [p, q, r] : triples)
  {
    const int found = projectionAxis(p, q, r);
    if (found >= 0)
    {
      return found;
    }
  }
  return -1;
}

/// Whether hulls in one plane share a point.
bool intersectInPlane(const Hull& a, const Hull& b)
{
  const int axis = commonAxis(a, b);
  if (axis < 0)
  {
    return !isBefore(a.points[1], b.points[0]) && !isBefore(b.points[1], a.points[0]);
  }
  return !edgesSeparate(a, b, axis) && !edgesSeparate(b, a, axis);
}

/// Whether the line through two points passes through a closed triangle. It must not lie in the
/// triangle's plane.
bool passesThrough(const glm::dvec3& from, const glm::dvec3& to, const Corners& triangle)
{
  const int first = orientation(from, to, triangle[0], triangle[1]);
  const int second = orientation(from, to, triangle[1], triangle[2]);
  if (first * second < 0)
  {
    return false;
  }
  const int third = orientation(from, to, triangle[2], triangle[0]);
  return first * third >= 0 && second * third >= 0;
}

/// Whether a triangle and a segment or point share a point.
bool intersectFlat(const Hull& triangle, const Hull& flat)
{
  const SidesOfPlane sides(triangle.points[0], triangle.points[1], triangle.points[2]);
  const int from = sides.side(flat.points[0]);
  const int to = sides.side(flat.points[1]);
  if (from == 0 && to == 0)
  {
    return intersectInPlane(triangle, flat);
  }
  return from != to && passesThrough(flat.points[0], flat.points[1], triangle.points);
}

/// As intersect(), for elements in one plane or without area.
bool intersectDegenerate(const Corners& a, const Corners& b)
{
  const Hull first(a);
  const Hull second(b);
  if (first.hasArea() != second.hasArea())
  {
    return first.hasArea() ? intersectFlat(first, second) : intersectFlat(second, first);
  }
  const bool inPlane = first.hasArea() ||
    orientation(first.points[0], first.points[1], second.points[0], second.points[1]) == 0;
  return inPlane && intersectInPlane(first, second);
}

} // namespace

bool intersect(const Element& a, const Element& b)
{
  const Sides sidesOfB = sidesOf(b.corners, a.corners);
  if (haveOneSign(sidesOfB))
  {
    return false;
  }
  const Sides sidesOfA = sidesOf(a.corners, b.corners);
  if (haveOneSign(sidesOfA))
  {
    return false;
  }
  if (areZero(sidesOfA) || areZero(sidesOfB))
  {
    return intersectDegenerate(a.corners, b.corners);
  }
  return overlapOnCommonLine(a.corners, sidesOfA, b.corners, sidesOfB);
}

bool crossing(const glm::dvec3& from, const glm::dvec3& to, const Element& triangle, glm::dvec3& at)
{
  const auto& [a, b, c] = triangle.corners;
  const glm::dvec3& low = isBefore(from, to) ? from : to;
  const glm::dvec3& high = isBefore(from, to) ? to : from;
  const SidesOfPlane sides(a, b, c);
  const int sideOfLow = sides.side(low);
  if (sideOfLow == sides.side(high) || !passesThrough(low, high, triangle.corners))
  {
    return false;
  }
  const glm::dvec3 normal = glm::cross(b - a, c - a);
  double heightOfLow = std::abs(glm::dot(normal, low - a));
  double heightOfHigh = std::abs(glm::dot(normal, high - a));
  constexpr double kUnreliable = 1e-7;
  const double unreliable = kUnreliable * glm::distance(a, b) * glm::distance(a, c) *
    (glm::distance(low, high) + glm::distance(low, a) + glm::distance(a, b));
  if (std::min(heightOfLow, heightOfHigh) < unreliable)
  {
    // Rounded, these have the exact signs, so that ends in the plane are met exactly.
    heightOfLow = std::abs(exact::determinant(a, b, c, low));
    heightOfHigh = std::abs(exact::determinant(a, b, c, high));
  }
  const double t = heightOfLow / (heightOfLow + heightOfHigh);
  at = glm::clamp(glm::mix(low, high, t), glm::min(low, high), glm::max(low, high));
  return true;
}

} // namespace medial
