#pragma once

#include "medial/grid.h"

#include <array>
#include <vector>

namespace medial
{

/// Splits a simple, possibly concave and roughly planar polygon into triangles.
///
/// Ears are clipped in the projection along the main axis of the Newell normal. A quad is split
/// along its valid diagonal, or along the shorter one if both are valid. A polygon that is not
/// simple still gives triangles over its corners; one without a normal gives a fan.
///
/// @param corners in order, at least three.
/// @return corners.size() - 2 triples of indices into `corners`, wound like the polygon.
std::vector<std::array<int, 3>> triangulatePolygon(const std::vector<Point3>& corners);

} // namespace medial
