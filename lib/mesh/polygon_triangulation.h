#pragma once

#include "medial/grid.h"

#include <array>
#include <vector>

namespace medial
{

/// Splits a simple, possibly concave and roughly planar polygon into triangles.
///
/// Ears are clipped in the projection along the main axis of the Newell normal; a quad is split
/// along its valid diagonal, the shorter one where both are. Polygons that are not simple still
/// give triangles over their corners, and those without a normal give a fan.
///
/// @param corners in order, at least three.
/// @return corners.size() - 2 triples of indices into `corners`, wound as the polygon.
std::vector<std::array<int, 3>> triangulatePolygon(const std::vector<Point3>& corners);

} // namespace medial
