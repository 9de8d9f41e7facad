#pragma once

#include "medial/axis_coverage.h"

#include <glm/glm.hpp>

#include <vector>

namespace medial
{

/// Joins neighbouring samples to places; returns the largest few of these, the largest first.
/// @param spacing samples closer than this belong together, and some that are up to 3.5 times as
///   far.
/// @param all number of samples that shares refer to.
std::vector<UncoveredPlace> uncoveredPlaces(const std::vector<glm::dvec3>& samples, double spacing,
  double all);

} // namespace medial
