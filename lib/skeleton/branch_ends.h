#pragma once

#include "skeleton/smooth_network.h"

namespace medial
{

/// Moves the free ends of a branch to where it ends in the solid.
/// @param step distance of points.
/// @param anew whether the curve next to them is not yet what it should be.
void finishEnds(NetworkBranch& branch, const SolidProbe& probe, double step, bool anew);

} // namespace medial
