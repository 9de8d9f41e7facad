#pragma once

#include "skeleton/smooth_network.h"

namespace medial
{

/// Makes one junction of two that a branch joins which is shorter than `minBranch` times the
/// smaller of their radii, and shorter than that radius. Returns whether there were any.
bool joinJunctions(GeometricNetwork& network, const SolidProbe& probe, double minBranch);

/// Moves junctions to where the lines cross that their branches follow outside the balls of the
/// junctions, and leads the branches there. Within those balls sheets of the axis bend the branches
/// towards each other.
void placeJunctions(GeometricNetwork& network, const SolidProbe& probe, double step);

} // namespace medial
