#pragma once

#include "balls/ball_union.h"

#include <glm/glm.hpp>

#include <functional>
#include <vector>

namespace medial
{

/// Spreads points evenly by area over the surface of a union of balls, cones and wedges. The points
/// do not depend on the number of threads. The surface of every part is sampled, and samples inside
/// other parts are dropped.
/// @param areaPerSample > 0.
/// @param tolerance points this deep inside another primitive still count as on the surface.
/// @param report called regularly with the share of the work that is done, in [0, 1]; its
///   exceptions end the work.
std::vector<glm::dvec3> boundarySamples(const BallUnion& solid, double areaPerSample,
  double tolerance, const std::function<void(double)>& report = {});

} // namespace medial
