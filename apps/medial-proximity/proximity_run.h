#pragma once

#include "proximity_command.h"

namespace medial::app
{

/// Reads the meshes, computes all pairs in all frames, writes the outputs and prints the table.
/// @throws Failure.
void runProximity(const ProximityCommand& command);

} // namespace medial::app
