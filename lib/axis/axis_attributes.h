#pragma once

#include "axis/bisector.h"
#include "medial/medial_axis.h"
#include "sites/grid_frame.h"

#include <cstddef>

namespace medial
{

/// Makes room for points and their attributes, features aside.
void resizeAxisPoints(std::size_t count, MedialAxis& axis);

/// Sets points and attributes in world units.
void setAxisPoints(const BisectorPoints& points, const GridFrame& frame, MedialAxis& axis);

} // namespace medial
