#pragma once

#include "axis/bisector_point.h"
#include "thinning/thinned_axis.h"

#include <vector>

namespace medial
{

/// Moves points back until every quad has an area and every line a length.
/// @param before the points of the axis before they were moved, with which all of them have.
void keepCellsSound(const std::vector<BisectorPoint>& before, ThinnedAxis& axis);

} // namespace medial
