#pragma once

#include "computation.h"
#include "options.h"

#include <string>
#include <vector>

namespace medial::app
{

/// The regions beyond the limits of thickness as lines of text, the first 20 of them.
std::string regionTable(const std::vector<ThicknessRegion>& regions);

/// Ends a run whose thickness is beyond its limits.
/// @throws Failure BeyondLimits, with the number of regions and the worst value.
void requireNoRegions(const Options& options, const Result& result);

} // namespace medial::app
