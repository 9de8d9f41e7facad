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
  double weight;     ///< area of the boundary that the plane stands for
  int vertex;        ///< the vertex that the plane belongs to
};

/// Finds the planes that the balls of each vertex should touch: planes tangent to the boundary of
/// the medial model (the union of balls, of cones between the two balls of an edge and of wedges
/// between the three of a triangle: Li et al., "Q-MAT", 2015, section 3), weighted by the area of
/// that boundary.
///
/// - A triangle gives the two planes that touch its three balls. If the closest pairs of the balls
///   are known, each of its corners instead gives the planes through its own pair: these do not
///   suffer from small errors of positions, such as those where sheets meet.
/// - An edge with a single triangle, where the boundary turns round the rim of a sheet, gives
///   planes along the arc between the two planes of the triangle. An edge without triangles gives
///   planes all around. An isolated vertex, the end of a line and the corner of a sheet give the
///   planes of their balls. Only planes that no other ball covers count here: a hole in a sheet
///   whose balls overlap has no rim.
///
/// So a spike (a sheet whose balls almost lie inside each other) has little weight. Moving its tip
/// by l into its base moves the boundary by l minus the difference of the radii, which is l times
/// the stability ratio of Q-MAT, and the area is small.
///
/// @param pairs the closest pairs of the balls; empty if they are not known.
/// @param complex without the links between components.
/// @return the planes in the order of their vertices.
std::vector<TangentPlane> boundaryPlanes(const std::vector<Ball>& balls,
  const std::vector<ClosestPair>& pairs, const BallComplex& complex);

} // namespace medial
