#pragma once

#include <glm/glm.hpp>

#include <limits>

namespace medial
{

struct Ball
{
  glm::dvec3 centre{ 0.0 };
  double radius = 0.0;
};

/// Where a point is with respect to a solid that is the union of a family of balls.
struct Contact
{
  double distance = 0.0; ///< signed distance to the solid's surface, negative inside
  Ball ball;             ///< the ball of the family that touches the surface nearest to the point
};

// Exact signed distances to convex hulls of balls, inside and outside. The hull of balls (c_i, r_i)
// is the union of the balls whose centre and radius are the same convex combination of theirs. Its
// signed distance is the least of |x - c| - r over these, a convex function of the combination: so
// the least over all of space, where it lies within the triangle (or segment), is the answer, and
// otherwise the least on the boundary is.

Contact contactWithBall(const Ball& ball, const glm::dvec3& x);

/// The convex hull of two balls; one of them where it holds the other.
Contact contactWithCone(const Ball& a, const Ball& b, const glm::dvec3& x);

/// The convex hull of three balls; that of two where the triangle has no area or the third adds
/// nothing.
/// @param limit where the distance is not below it, another one that is not either may be returned.
Contact contactWithSlab(const Ball& a, const Ball& b, const Ball& c, const glm::dvec3& x,
  double limit = std::numeric_limits<double>::infinity());

/// The planes that touch three balls from outside, on either side of their triangle.
struct TangentPlanes
{
  bool exist = false;      ///< false for a triangle without area or where radii differ too much
  glm::dvec3 normals[2]{}; ///< outward, unit; ball (c, r) is touched at c + r normal
};

TangentPlanes tangentPlanes(const Ball& a, const Ball& b, const Ball& c);

} // namespace medial
