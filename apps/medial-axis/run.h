#pragma once

#include "options.h"

namespace medial::app
{

/// Reads the mesh, computes, writes what the user asked for, and prints a summary. All outputs
/// appear together at the end, or none.
/// @throws Failure; BeyondLimits after everything is done.
void run(const Options& options);

} // namespace medial::app
