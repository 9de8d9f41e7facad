#pragma once

#include "balls/ball.h"

#include <glm/glm.hpp>

#include <array>
#include <limits>
#include <optional>

// The exact geometry of convex hulls of balls: of two, cones, and of three, wedges.
//
// The hull of balls (c_i, r_i) is the union of the balls whose centre and radius are the same
// convex combination of theirs. Its signed distance from x is the minimum of |x - c| - r over
// these, a convex function of the combination: so the minimum over all of space, where it lies
// within the triangle (or segment), is the answer, and otherwise the minimum on the boundary is.
namespace medial
{

/// The position of a point relative to a solid that is the union of a family of balls.
struct HullDistance
{
  double distance = 0.0; ///< signed distance to the solid's surface, negative inside
  Ball ball;             ///< the ball of the family that touches the surface nearest to the point
};

inline HullDistance distanceToBall(const Ball& ball, const glm::dvec3& x)
{
  return { glm::distance(x, ball.centre) - ball.radius, ball };
}

/// Returns the distance to the convex hull of two balls, or to one of them if it contains the
/// other.
HullDistance distanceToCone(const Ball& a, const Ball& b, const glm::dvec3& x);

/// Returns the distance to the convex hull of three balls, or to that of two if the triangle has no
/// area or the third adds nothing.
/// @param limit if the distance is not below it, any other value that is not below it may be
///   returned.
HullDistance distanceToWedge(const Ball& a, const Ball& b, const Ball& c, const glm::dvec3& x,
  double limit = std::numeric_limits<double>::infinity());

/// Returns a lower bound of the distance to the convex hull of three balls, but for rounding.
double wedgeBound(const Ball& a, const Ball& b, const Ball& c, const glm::dvec3& x);

/// Returns the outward unit normals of the two planes that touch three balls from outside: each
/// touches ball (c, r) at c + r normal. Nothing for a triangle without area or if the radii differ
/// too much.
std::optional<std::array<glm::dvec3, 2>> tangentNormals(const Ball& a, const Ball& b,
  const Ball& c);

// These functions serve simplification, which needs more than distances. They find the same planes
// and the same nearest balls as the functions above, except for the last bits; the result of
// simplification depends on these.

/// The planes that touch two balls have the unit normals slope * axis + sine * radial, where radial
/// is any unit vector at right angles to the axis.
struct Cone
{
  glm::dvec3 axis; ///< unit vector between the centres
  double slope;
  double sine; ///< (0, 1]
  double length;
};

/// The planes that touch three balls have the unit normals slope +- sine * up.
struct Wedge
{
  glm::dvec3 slope; ///< in the plane of the centres, against the growth of the radii
  glm::dvec3 up;    ///< unit normal of that plane
  double sine;      ///< of half the angle between the two normals, (0, 1]
  double area;      ///< of the triangle of centres

  /// @param sign 1 or -1.
  glm::dvec3 normal(double sign) const { return slope + sign * sine * up; }
};

///@{
/// Nothing if no plane touches all balls, since one lies inside another or inside the hull of the
/// others, or if centres coincide or almost lie on a line.
std::optional<Cone> coneOf(const Ball& a, const Ball& b);
std::optional<Wedge> wedgeOf(const Ball& a, const Ball& b, const Ball& c);
///@}

/// Returns the shares of two balls in that ball of their cone whose surface is nearest to x.
std::array<double, 2> nearestShares(const Ball& a, const Ball& b, const glm::dvec3& x);

/// Returns the shares of three balls in that ball of their wedge whose surface is nearest to x.
/// Nothing if it is a ball of one of the wedge's cones, or if wedgeOf() has nothing.
std::optional<std::array<double, 3>> nearestShares(const Ball& a, const Ball& b, const Ball& c,
  const glm::dvec3& x);

} // namespace medial
