#include "balls/ball_hulls.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace medial
{
namespace
{

/// Triangles whose height is below this share of their longest side have no plane.
constexpr double kMinHeight = 1e-9;

/// A triangle of centres with what follows from it for the radius.
struct SlabPlane
{
  bool usable = false;
  glm::dvec3 normal;    ///< not of unit length
  double normalSquared; ///< its squared length
  glm::dvec3 dualB;     ///< dot with a vector of the plane from a: coordinate of b
  glm::dvec3 dualC;
  glm::dvec3 gradient; ///< of the radius
  double rise;         ///< sqrt(1 - squared length of the gradient)
};

SlabPlane slabPlane(const Ball& a, const Ball& b, const Ball& c)
{
  SlabPlane plane{};
  const glm::dvec3 u = b.centre - a.centre;
  const glm::dvec3 v = c.centre - a.centre;
  const double longest = std::max({ glm::dot(u, u), glm::dot(v, v), glm::dot(v - u, v - u) });
  plane.normal = glm::cross(u, v);
  plane.normalSquared = glm::dot(plane.normal, plane.normal);
  if (plane.normalSquared <= kMinHeight * kMinHeight * longest * longest)
  {
    return plane;
  }
  plane.dualB = glm::cross(v, plane.normal) / plane.normalSquared;
  plane.dualC = glm::cross(plane.normal, u) / plane.normalSquared;
  plane.gradient = (b.radius - a.radius) * plane.dualB + (c.radius - a.radius) * plane.dualC;
  const double slope = glm::dot(plane.gradient, plane.gradient);
  plane.usable = slope < 1.0;
  plane.rise = plane.usable ? std::sqrt(1.0 - slope) : 0.0;
  return plane;
}

/// What the distance to a slab does not fall below: a convex function lies above its tangent, here
/// at the middle of the triangle.
Contact slabBound(const Ball& a, const Ball& b, const Ball& c, const glm::dvec3& x)
{
  constexpr double kThird = 1.0 / 3.0;
  const glm::dvec3 middle = kThird * (a.centre + b.centre + c.centre);
  const glm::dvec3 fromX = middle - x;
  const double distance = glm::length(fromX);
  if (distance == 0.0)
  {
    return { -std::numeric_limits<double>::infinity(), a };
  }
  const glm::dvec3 slope = fromX / distance;
  const auto tangent = [&](const Ball& ball)
  { return glm::dot(slope, ball.centre - middle) - ball.radius; };
  return { distance + std::min({ tangent(a), tangent(b), tangent(c) }), a };
}

const Contact& nearer(const Contact& a, const Contact& b)
{
  return b.distance < a.distance ? b : a;
}

} // namespace

Contact contactWithBall(const Ball& ball, const glm::dvec3& x)
{
  return { glm::distance(x, ball.centre) - ball.radius, ball };
}

Contact contactWithCone(const Ball& a, const Ball& b, const glm::dvec3& x)
{
  const glm::dvec3 along = b.centre - a.centre;
  const double squared = glm::dot(along, along);
  const double growth = b.radius - a.radius;
  if (growth * growth >= squared)
  {
    return contactWithBall(growth > 0.0 ? b : a, x);
  }
  const glm::dvec3 toX = x - a.centre;
  const double foot = glm::dot(toX, along) / squared;
  const double height = glm::length(toX - foot * along);
  // The ball that touches the cone where x is nearest lies by this farther to the thick end.
  const double shift = height * growth / (squared * std::sqrt(1.0 - growth * growth / squared));
  const double t = std::clamp(foot + shift, 0.0, 1.0);
  return contactWithBall({ a.centre + t * along, a.radius + t * growth }, x);
}

Contact contactWithSlab(const Ball& a, const Ball& b, const Ball& c, const glm::dvec3& x,
  double limit)
{
  const Contact bound = slabBound(a, b, c, x);
  if (bound.distance >= limit)
  {
    return bound;
  }
  const SlabPlane plane = slabPlane(a, b, c);
  if (!plane.usable)
  {
    return nearer(nearer(contactWithCone(a, b, x), contactWithCone(b, c, x)),
      contactWithCone(c, a, x));
  }
  const glm::dvec3 toX = x - a.centre;
  const double lift = glm::dot(toX, plane.normal) / plane.normalSquared;
  const double height = std::abs(lift) * std::sqrt(plane.normalSquared);
  const glm::dvec3 centre = toX - lift * plane.normal + height / plane.rise * plane.gradient;
  const double radius = a.radius + glm::dot(plane.gradient, centre);
  const Contact onPlane{ height / plane.rise - radius, { a.centre + centre, radius } };
  const double atB = glm::dot(centre, plane.dualB);
  const double atC = glm::dot(centre, plane.dualC);
  if (onPlane.distance >= limit || (atB >= 0.0 && atC >= 0.0 && atB + atC <= 1.0))
  {
    return onPlane;
  }
  // The least of a convex function over the triangle lies on a side that the least of all is
  // beyond.
  Contact best;
  best.distance = std::numeric_limits<double>::infinity();
  best = atC < 0.0 ? contactWithCone(a, b, x) : best;
  best = atB < 0.0 ? nearer(best, contactWithCone(c, a, x)) : best;
  return atB + atC > 1.0 ? nearer(best, contactWithCone(b, c, x)) : best;
}

TangentPlanes tangentPlanes(const Ball& a, const Ball& b, const Ball& c)
{
  const SlabPlane plane = slabPlane(a, b, c);
  TangentPlanes result;
  result.exist = plane.usable;
  if (plane.usable)
  {
    const glm::dvec3 up = plane.rise * plane.normal / std::sqrt(plane.normalSquared);
    result.normals[0] = up - plane.gradient;
    result.normals[1] = -up - plane.gradient;
  }
  return result;
}

} // namespace medial
