#pragma once

#include "balls/ball.h"
#include "simplification/ball_complex.h"
#include "simplification/boundary_planes.h"

#include <functional>
#include <vector>

namespace medial
{

/// Moves the balls of a simplified complex so that the boundary of their cones and wedges, not only
/// that of the balls themselves, passes through the points of the planes. It takes damped
/// Gauss-Newton steps on the weighted squared distances, of each point to the nearest cell around
/// its ball, and stops when a step does not help. Balls do not move where a triangle would turn
/// over or lose its area.
///
/// The quadrics of the balls also count, with a small weight, so that no ball grows beyond the
/// surface where no point is near. If there are very many points, only some of them are used.
///
/// @param representatives the ball that each vertex of the planes has been merged into.
/// @param step called before each step with the share of the steps that is done.
void fitBalls(const std::vector<TangentPlane>& planes, const std::vector<int>& representatives,
  const BallComplex& complex, std::vector<Ball>& balls, const std::function<void(double)>& step);

} // namespace medial
