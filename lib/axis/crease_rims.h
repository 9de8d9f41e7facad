#pragma once

#include "axis/bisector.h"
#include "axis/dual_mesh.h"

namespace medial
{

/// Moves the rims of a surface's sheets out to the sharp convex edges in which the sheets end:
/// grid edges that cross a sheet with both ends on one side of the surface stop about a grid step
/// before. Balls of a twentieth of a grid step, or the least radius or lambda, are left there.
/// @param points vertices of `mesh`; the moved ones keep the least separation angle.
void extendRims(const AxisGeometry& geometry, const DualMesh& mesh, BisectorPoints& points);

} // namespace medial
