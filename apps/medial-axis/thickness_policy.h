#pragma once

#include "options.h"

#include "medial/thickness_regions.h"

namespace medial::app
{

/// Longest edge of the surface whose thickness is computed, world units; 0 leaves it as it is.
/// @param diagonal of the mesh's bounds.
double maxThicknessEdge(const Options& options, double diagonal);

/// @throws Failure Usage for limits of thickness that contradict each other.
void requireLimits(const ThicknessLimits& limits);

} // namespace medial::app
