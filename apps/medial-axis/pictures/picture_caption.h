#pragma once

#include "options.h"
#include "result.h"

#include <string>
#include <vector>

// What pictures and pages say at the top: what is drawn, and how it was computed.
namespace medial::app
{

/// Name of the mesh's file; what is selected; grid, topology and limit of spheres.
std::vector<std::string> axisCaption(const Options& options, const Result& result);

/// Name of the mesh's file; method and side of the thickness, and the angle of balls; what is
/// beyond the limits.
std::vector<std::string> thicknessCaption(const Options& options, const Result& result);

/// Name of the mesh's file; side of the local thickness and grid.
std::vector<std::string> localThicknessCaption(const Options& options, const Result& result);

} // namespace medial::app
