#pragma once

#include "medial/medial/simplification/ball_complex.h"
#include "medial/medial/simplification/ball_quadric.h"

#include <vector>

namespace medial
{

/// What the balls that a vertex stands for should touch: the planes tangent to the boundary of the
/// medial model (the union of balls, of cones between the two balls of an edge and of slabs between
/// the three of a triangle: Li et al., "Q-MAT", 2015, section 3), weighted by the
/// area of that boundary.
///
/// - A triangle gives the two planes that touch its three balls.
/// - An edge with a single triangle, where the boundary turns round the rim of a sheet, gives
/// planes
///   along the arc from one of the two to the other; an edge without triangles planes all around;
///   an isolated or last vertex of a line those of its sphere. Of these, only planes count that no
///   other ball covers: a hole in a sheet whose balls overlap has no rim.
///
/// So a spike (a sheet whose balls all but lie in each other) weighs little: moving its tip by l
/// into its base moves the boundary by l minus the difference of the radii, which is l times the
/// stability ratio of Q-MAT, and the area is small.
///
/// @param complex without the links between components.
std::vector<BallQuadric> boundaryQuadrics(const std::vector<Ball>& balls,
  const BallComplex& complex);

} // namespace medial
