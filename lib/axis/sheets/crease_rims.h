#pragma once

#include "axis/bisector.h"

#include <cstddef>
#include <vector>

namespace medial
{

/// Extends the rims of sheets to the sharp convex edges in which the sheets end. Without this they
/// stop about a grid step before, since only grid edges with both ends on one side of the surface
/// cross a sheet. The last balls have a radius of a twentieth of a grid step, or the minimum radius
/// or lambda.
/// @param vertices those on rims, unless they have reached a border.
/// @param points vertices of a dual mesh; those that move keep the minimum separation angle.
void extendRims(const AxisGeometry& geometry, const std::vector<std::size_t>& vertices,
  BisectorPoints& points);

} // namespace medial
