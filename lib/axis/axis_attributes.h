#pragma once

#include "axis/bisector.h"
#include "medial/medial_axis.h"
#include "sites/grid_frame.h"

namespace medial
{

/// Sets points and attributes in world units.
void setAxisPoints(const BisectorPoints& points, const GridFrame& frame, MedialAxis& axis);

} // namespace medial
