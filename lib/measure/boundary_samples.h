#pragma once

#include "balls/ball_union.h"

#include <glm/glm.hpp>

#include <functional>
#include <vector>

namespace medial
{

/// Points on the surface of a union of balls, cones and wedges, evenly spread by area; always the
/// same ones, whatever the number of threads. The surface of every part is sampled, and what lies
/// inside another part is left out.
/// @param areaPerSample > 0.
/// @param tolerance how deep inside another primitive a point still counts as on the surface.
/// @param report told now and then what share in [0, 1] is done; its exceptions end the work.
std::vector<glm::dvec3> boundarySamples(const BallUnion& solid, double areaPerSample,
  double tolerance, const std::function<void(double)>& report = {});

} // namespace medial
