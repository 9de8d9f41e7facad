#pragma once

#include "axis/bisector.h"
#include "medial/compute_medial_axis.h"
#include "sites/grid_frame.h"

// Steps on the way to an axis, in one process and on several.
namespace medial
{

/// @throws Error InvalidInput as computeMedialAxis().
void checkAxisOptions(const MedialAxisOptions& options);

/// Returns the angle by which grid edges are selected, degrees.
double selectionAngle(const MedialAxisOptions& options);

/// Sets points and attributes in world units.
void setAxisPoints(const BisectorPoints& points, const GridFrame& frame, MedialAxis& axis);

} // namespace medial
