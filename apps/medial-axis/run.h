#pragma once

#include "options.h"

namespace medial::app
{

/// Reads the mesh, computes, writes everything that was asked for, and says so on standard output.
/// All outputs appear together at the end, or none.
/// @throws Failure.
void run(const Options& options);

} // namespace medial::app
