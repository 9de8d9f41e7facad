#pragma once

#include "axis/axis_geometry.h"
#include "axis/bisector.h"
#include "field/crossing.h"
#include "medial/medial_axis.h"

#include <vector>

namespace medial
{

/// How sheets end where they end in no crease.
enum class SheetEnds
{
  AtBorder, ///< in a smooth line, where the limits of the axis are reached
  OnGrid    ///< at their last cells
};

/// Makes the cells of an axis with Representation::Surface, and returns its points.
/// @param crossings selected by bandAngle(); only those that the axis has stay.
BisectorPoints surfaceOf(const AxisGeometry& geometry, std::vector<Crossing>& crossings,
  MedialAxis& axis, SheetEnds ends = SheetEnds::AtBorder);

} // namespace medial
