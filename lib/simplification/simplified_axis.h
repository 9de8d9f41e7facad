#pragma once

#include "balls/ball.h"
#include "medial/medial_axis.h"
#include "simplification/axis_balls.h"
#include "simplification/ball_complex.h"

#include <vector>

namespace medial
{

/// What is left of an axis after simplification.
struct SimplifiedBalls
{
  const std::vector<Ball>& balls;          ///< one per point of the axis
  const BallComplex& complex;              ///< its vertices are the balls that are left
  const std::vector<int>& representatives; ///< the ball that each point has been merged into
};

/// Makes the simplified axis: points, cells and features. Other values come from the nearest of the
/// points that a ball represents.
/// @param frame the coordinates of the balls, and the points of `axis` in them.
MedialAxis simplifiedAxis(const MedialAxis& axis, const AxisBalls& frame,
  const SimplifiedBalls& simplified);

} // namespace medial
