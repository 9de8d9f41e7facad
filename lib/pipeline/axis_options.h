#pragma once

#include "axis/axis_geometry.h"
#include "medial/compute_medial_axis.h"
#include "medial/side.h"

// What options of an axis mean, in one process and on several.
namespace medial
{

/// @throws Error InvalidInput as computeMedialAxis().
void checkAxisOptions(const MedialAxisOptions& options);

/// Share of the work that is done once the crossings are selected.
constexpr double kSelectedShare = 0.8;

/// Returns the angle by which grid edges are selected, degrees.
double selectionAngle(const MedialAxisOptions& options);

/// Returns what the options ask of the points of an axis, local units.
AxisLimits limitsOf(const MedialAxisOptions& options, const GridFrame& frame);

/// Returns the side that an axis is on: without a sign it is on both.
Side sideOf(Side wanted, bool hasSign);

} // namespace medial
