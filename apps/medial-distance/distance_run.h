#pragma once

#include "distance_command.h"

namespace medial::app
{

/// Reads mesh and points, computes, and writes what was asked for.
/// @throws Failure.
void runDistance(const DistanceCommand& command);

} // namespace medial::app
