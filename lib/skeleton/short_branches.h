#pragma once

#include "skeleton/smooth_network.h"

#include <cstddef>
#include <vector>

namespace medial
{

/// What removeShortBranches() did.
struct ShortBranches
{
  bool removed = false;
  std::vector<std::size_t> merged; ///< branches made of two that a removed one had kept apart
};

/// Removes branches with a free end that are shorter than `minBranch` times the radius at their
/// junction, or reach out of the balls of all others by less than `minBranch` times their own
/// radius there; one after the other, the worst first. Where two branches are left at a junction,
/// they become one.
/// @param step distance of points. A radius below it counts as that much, since the grid of the
/// axis does not show what is thinner.
ShortBranches removeShortBranches(GeometricNetwork& network, const SolidProbe& probe, double step,
  double minBranch, const Checkpoint& checkpoint);

} // namespace medial
