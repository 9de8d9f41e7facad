#pragma once

#include "balls/ball.h"
#include "simplification/axis_balls.h"
#include "simplification/ball_complex.h"

#include <glm/glm.hpp>

#include <vector>

namespace medial
{

/// A plane that touches the boundary.
struct TangentPlane
{
  glm::dvec3 point;
  glm::dvec3 normal; ///< outward unit normal
  double weight;     ///< area of the boundary that it stands for
  int vertex;        ///< that it belongs to
};

/// What the balls that a vertex stands for should touch: the planes tangent to the boundary of the
/// medial model (the union of balls, of cones between the two balls of an edge and of wedges
/// between the three of a triangle: Li et al., "Q-MAT", 2015, section 3), weighted by the area of
/// that boundary.
///
/// - A triangle gives the two planes that touch its three balls; or, where the closest points of
///   the balls are known, each of its corners gives the planes through its own two, which do not
///   suffer from small errors of the positions, as where sheets meet.
/// - An edge with a single triangle, where the boundary turns round the rim of a sheet, gives
///   planes along the arc from one of the two to the other; an edge without triangles planes all
///   around; an isolated vertex, the last of a line and the corner of a sheet those of their balls.
///   Of these, only planes count that no other ball covers: a hole in a sheet whose balls overlap
///   has no rim.
///
/// So a spike (a sheet whose balls all but lie in each other) weighs little: moving its tip by l
/// into its base moves the boundary by l minus the difference of the radii, which is l times the
/// stability ratio of Q-MAT, and the area is small.
///
/// @param pairs the closest points of the balls; empty where they are not known.
/// @param complex without the links between components.
/// @return the planes in the order of their vertices.
std::vector<TangentPlane> boundaryPlanes(const std::vector<Ball>& balls,
  const std::vector<ClosestPair>& pairs, const BallComplex& complex);

} // namespace medial
