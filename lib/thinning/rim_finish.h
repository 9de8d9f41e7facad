#pragma once

#include "axis/axis_geometry.h"
#include "axis/edge_table.h"
#include "axis/sheets/sheet_selection.h"
#include "thinning/thinned_axis.h"

#include <cstddef>
#include <vector>

namespace medial
{

/// Returns the rims of a thinned axis between points on selected faces: edges of one quad only.
std::vector<EdgeTable::Edge> selectedRims(const ThinnedAxis& axis);

/// Gives the rims of a thinned axis the finish of a selected one: they move to the borders of what
/// is selected (moveToBorders()) and to sharp convex edges (extendRims()). Rims where no face is
/// selected stay where the fire has stopped.
///
/// Only points move, so the topology stays. Those that would leave a cell without area or length
/// go back to their places.
void finishRims(const AxisGeometry& geometry, const SheetSelection& sheets, ThinnedAxis& axis);

} // namespace medial
