#pragma once

#include "balls/ball.h"
#include "medial/medial_axis.h"
#include "simplification/axis_balls.h"
#include "simplification/ball_complex.h"

#include <vector>

namespace medial
{

/// What simplification has left of an axis, as an axis.
struct SimplifiedBalls
{
  const std::vector<Ball>& balls;          ///< one a point of the axis
  const BallComplex& complex;              ///< its vertices are the balls that are left
  const std::vector<int>& representatives; ///< the ball that each point has been merged into
};

/// Points, cells and features of a simplified axis. Values that are not the balls' own are those of
/// the nearest of the points that a ball represents.
/// @param frame the coordinates of the balls, and the points of `axis` in them.
MedialAxis simplifiedAxis(const MedialAxis& axis, const AxisBalls& frame,
  const SimplifiedBalls& simplified);

} // namespace medial
