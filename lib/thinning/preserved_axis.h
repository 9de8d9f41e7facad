#pragma once

#include "axis/axis_geometry.h"
#include "axis/sheets/sheet_selection.h"
#include "field/crossing.h"
#include "medial/cell_topology.h"
#include "medial/representation.h"
#include "medial/side.h"
#include "thinning/curve_chains.h"
#include "thinning/thinned_axis.h"

#include <cstdint>
#include <vector>

namespace medial
{

/// An axis with the topology of its solid.
struct PreservedAxis
{
  ThinnedAxis cells;
  CellTopology solid;
};

/// What to thin, with the field at all grid points, x fastest.
struct ThinningInput
{
  const float* distances; ///< world units
  const std::int32_t* closestSites;
  /// Per triangle 1 if it faces outwards as it is, or -1. Empty without a sign.
  const std::vector<std::int8_t>& directions;
  Side side; ///< Both if there is no sign
  Representation representation;
};

/// Adds what one solid has to others that do not touch it.
void add(const CellTopology& part, CellTopology& whole);

/// Returns the sides to thin, one after the other.
std::vector<Side> sidesOf(bool hasSign, Side side);

/// Returns which curves an axis keeps.
CurveLimits limitsOf(const AxisGeometry& geometry);

/// Thins the voxels of each side asked for to an axis of the same topology (SolidThinning).
///
/// Needs 10 bytes per grid point, including the field, and memory for the front of the fire.
/// Surfaces get the finish of selected ones: finishRims().
///
/// @param crossings the selected ones.
PreservedAxis preserveTopology(const ThinningInput& input, const AxisGeometry& geometry,
  const std::vector<Crossing>& crossings, const SheetSelection& sheets);

} // namespace medial
