#pragma once

#include "balls/ball.h"
#include "simplification/ball_complex.h"
#include "simplification/boundary_planes.h"

#include <functional>
#include <vector>

namespace medial
{

/// Moves the balls of a simplified complex so that the boundary of their cones and wedges, not only
/// that of the balls themselves, runs through the points of the planes: damped Gauss-Newton steps
/// on the weighted squared distances, each point against the nearest cell around the ball that it
/// belongs to. Balls do not move where a triangle would turn over or lose its area. Stops when a
/// step does not help.
///
/// The quadrics of the balls by themselves take part with a small weight, so that no ball grows
/// beyond the surface where no point is next to it. Of very many points a share is used.
///
/// @param representatives the ball that each vertex of the planes has been merged into.
/// @param step called before each step with the share of them that is done.
void fitBalls(const std::vector<TangentPlane>& planes, const std::vector<int>& representatives,
  const BallComplex& complex, std::vector<Ball>& balls, const std::function<void(double)>& step);

} // namespace medial
