#pragma once

#include "medial/compute_medial_axis.h"

// What options of an axis mean, in one process and on several.
namespace medial
{

/// @throws Error InvalidInput as computeMedialAxis().
void checkAxisOptions(const MedialAxisOptions& options);

/// Returns the angle by which grid edges are selected, degrees.
double selectionAngle(const MedialAxisOptions& options);

} // namespace medial
