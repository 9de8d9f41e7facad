#pragma once

#include "axis/axis_geometry.h"
#include "axis/bisector.h"
#include "axis/edge_table.h"
#include "axis/sheet_selection.h"

#include <cstddef>
#include <vector>

namespace medial
{

/// Moves the rims of sheets to the borders of what is selected: to where the separation angle,
/// lambda or the radius of the sheet reaches its limit, or to the seam at which the sheet ends. The
/// cells stay as they are, so neighbours share the border and no crack opens.
///
/// A rim is about a grid cell away from its border at most. Its vertices go to the nearest place
/// where a SheetFit reaches the limit, or where another site is nearer. The line that they form is
/// smoothed, since facets make it jagged, and put onto the bisector.
/// @param rims edges of one quad only.
/// @param origins for each vertex that of the samples' mesh.
/// @param points of the vertices.
/// @return the vertices of rims that have no border.
std::vector<std::size_t> moveToBorders(const AxisGeometry& geometry,
  const SheetSelection& selection, const std::vector<EdgeTable::Edge>& rims,
  const std::vector<std::size_t>& origins, BisectorPoints& points);

} // namespace medial
