#pragma once

#include "options.h"
#include "result.h"

#include <cstddef>
#include <string>
#include <vector>

namespace medial::app
{

/// As many regions are listed and numbered in pictures.
constexpr std::size_t kListedRegions = 20;

/// The first kListedRegions regions beyond the limits of thickness as lines of text.
std::string regionTable(const std::vector<ThicknessRegion>& regions);

/// How many regions are beyond which limit, and the worst value, as "2 regions are thinner than 1,
/// the worst 0.4"; empty if there are none.
std::string regionSummary(const Options& options, const Result& result);

/// Ends a run whose thickness is beyond its limits.
/// @throws Failure BeyondLimits, with the number of regions and the worst value.
void requireNoRegions(const Options& options, const Result& result);

} // namespace medial::app
