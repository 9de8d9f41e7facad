#include "balls/ball_hulls.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace medial
{
namespace
{

/// Triangles with a height below this share of their longest edge have no plane.
constexpr double kMinHeight = 1e-9;
/// The same, if the normal itself is needed.
constexpr double kMinReliableHeight = 1e-6;

/// A triangle of centres, and the radius as a function over its plane.
struct WedgePlane
{
  bool usable = false;
  glm::dvec3 normal;    ///< not of unit length
  double normalSquared; ///< its squared length
  glm::dvec3 dualB;     ///< dot with a vector of the plane from a: coordinate of b
  glm::dvec3 dualC;
  glm::dvec3 gradient; ///< of the radius
  double rise;         ///< sqrt(1 - squared length of the gradient)
};

WedgePlane wedgePlane(const Ball& a, const Ball& b, const Ball& c)
{
  WedgePlane plane{};
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

const HullDistance& nearer(const HullDistance& a, const HullDistance& b)
{
  return b.distance < a.distance ? b : a;
}

} // namespace

HullDistance distanceToCone(const Ball& a, const Ball& b, const glm::dvec3& x)
{
  const glm::dvec3 along = b.centre - a.centre;
  const double squared = glm::dot(along, along);
  const double growth = b.radius - a.radius;
  if (growth * growth >= squared)
  {
    return distanceToBall(growth > 0.0 ? b : a, x);
  }
  const glm::dvec3 toX = x - a.centre;
  const double foot = glm::dot(toX, along) / squared;
  const double height = glm::length(toX - foot * along);
  // The ball that touches the cone nearest to x is shifted by this towards the thick end.
  const double shift = height * growth / (squared * std::sqrt(1.0 - growth * growth / squared));
  const double t = std::clamp(foot + shift, 0.0, 1.0);
  return distanceToBall({ a.centre + t * along, a.radius + t * growth }, x);
}

HullDistance distanceToWedge(const Ball& a, const Ball& b, const Ball& c, const glm::dvec3& x,
  double limit)
{
  const double bound = wedgeBound(a, b, c, x);
  if (bound >= limit)
  {
    return { bound, a };
  }
  const WedgePlane plane = wedgePlane(a, b, c);
  if (!plane.usable)
  {
    return nearer(nearer(distanceToCone(a, b, x), distanceToCone(b, c, x)),
      distanceToCone(c, a, x));
  }
  const glm::dvec3 toX = x - a.centre;
  const double lift = glm::dot(toX, plane.normal) / plane.normalSquared;
  const double height = std::abs(lift) * std::sqrt(plane.normalSquared);
  const glm::dvec3 centre = toX - lift * plane.normal + height / plane.rise * plane.gradient;
  const double radius = a.radius + glm::dot(plane.gradient, centre);
  const HullDistance onPlane{ height / plane.rise - radius, { a.centre + centre, radius } };
  const double atB = glm::dot(centre, plane.dualB);
  const double atC = glm::dot(centre, plane.dualC);
  if (onPlane.distance >= limit || (atB >= 0.0 && atC >= 0.0 && atB + atC <= 1.0))
  {
    return onPlane;
  }
  // The minimum of a convex function over the triangle lies on an edge that separates the triangle
  // from the minimum over all.
  HullDistance best;
  best.distance = std::numeric_limits<double>::infinity();
  best = atC < 0.0 ? distanceToCone(a, b, x) : best;
  best = atB < 0.0 ? nearer(best, distanceToCone(c, a, x)) : best;
  return atB + atC > 1.0 ? nearer(best, distanceToCone(b, c, x)) : best;
}

// A convex function lies above its tangent, here at the middle of the triangle.
double wedgeBound(const Ball& a, const Ball& b, const Ball& c, const glm::dvec3& x)
{
  constexpr double kThird = 1.0 / 3.0;
  const glm::dvec3 middle = kThird * (a.centre + b.centre + c.centre);
  const glm::dvec3 fromX = middle - x;
  const double distance = glm::length(fromX);
  if (distance == 0.0)
  {
    return -std::numeric_limits<double>::infinity();
  }
  const glm::dvec3 slope = fromX / distance;
  const auto tangent = [&](const Ball& ball)
  { return glm::dot(slope, ball.centre - middle) - ball.radius; };
  return distance + std::min({ tangent(a), tangent(b), tangent(c) });
}

std::optional<std::array<glm::dvec3, 2>> tangentNormals(const Ball& a, const Ball& b, const Ball& c)
{
  const WedgePlane plane = wedgePlane(a, b, c);
  if (!plane.usable)
  {
    return std::nullopt;
  }
  const glm::dvec3 up = plane.rise * plane.normal / std::sqrt(plane.normalSquared);
  return std::array<glm::dvec3, 2>{ up - plane.gradient, -up - plane.gradient };
}

std::optional<Cone> coneOf(const Ball& a, const Ball& b)
{
  Cone cone;
  cone.axis = b.centre - a.centre;
  cone.length = glm::length(cone.axis);
  const double difference = a.radius - b.radius;
  if (!(cone.length > std::abs(difference)))
  {
    return std::nullopt;
  }
  cone.axis /= cone.length;
  cone.slope = difference / cone.length;
  cone.sine = std::sqrt(1.0 - cone.slope * cone.slope);
  return cone;
}

std::optional<Wedge> wedgeOf(const Ball& a, const Ball& b, const Ball& c)
{
  const glm::dvec3 e = b.centre - a.centre;
  const glm::dvec3 f = c.centre - a.centre;
  const glm::dvec3 normal = glm::cross(e, f);
  const double twice = glm::length(normal);
  const double ee = glm::dot(e, e);
  const double ff = glm::dot(f, f);
  if (!(twice > kMinReliableHeight * std::max(ee, ff)))
  {
    return std::nullopt;
  }
  // slope . e = a.radius - b.radius and slope . f = a.radius - c.radius, within the plane.
  const double ef = glm::dot(e, f);
  const double p = a.radius - b.radius;
  const double q = a.radius - c.radius;
  const double determinant = twice * twice;
  Wedge wedge;
  wedge.slope = ((p * ff - q * ef) * e + (q * ee - p * ef) * f) / determinant;
  const double sine2 = 1.0 - glm::dot(wedge.slope, wedge.slope);
  if (!(sine2 > 0.0))
  {
    return std::nullopt;
  }
  wedge.sine = std::sqrt(sine2);
  wedge.up = normal / twice;
  wedge.area = 0.5 * twice;
  return wedge;
}

std::array<double, 2> nearestShares(const Ball& a, const Ball& b, const glm::dvec3& x)
{
  const auto cone = coneOf(a, b);
  if (!cone)
  {
    return a.radius > b.radius ? std::array{ 1.0, 0.0 } : std::array{ 0.0, 1.0 };
  }
  const glm::dvec3 d = x - a.centre;
  const double along = glm::dot(d, cone->axis);
  const double height = glm::length(d - along * cone->axis);
  const double t = (along - cone->slope * height / cone->sine) / cone->length;
  const double share = std::clamp(t, 0.0, 1.0);
  return { 1.0 - share, share };
}

std::optional<std::array<double, 3>> nearestShares(const Ball& a, const Ball& b, const Ball& c,
  const glm::dvec3& x)
{
  const auto wedge = wedgeOf(a, b, c);
  if (!wedge)
  {
    return std::nullopt;
  }
  const glm::dvec3 e = b.centre - a.centre;
  const glm::dvec3 f = c.centre - a.centre;
  // The centre of the nearest ball is not the foot of the perpendicular, but shifted towards
  // growing radii.
  const double height = glm::dot(x - a.centre, wedge->up);
  const glm::dvec3 d =
    x - a.centre - height * wedge->up - wedge->slope * (std::abs(height) / wedge->sine);
  const double s = glm::dot(glm::cross(d, f), wedge->up) / (2.0 * wedge->area);
  const double t = glm::dot(glm::cross(e, d), wedge->up) / (2.0 * wedge->area);
  if (s < 0.0 || t < 0.0 || s + t > 1.0)
  {
    return std::nullopt;
  }
  return std::array{ 1.0 - s - t, s, t };
}

} // namespace medial
