#pragma once

#include "axis/axis_geometry.h"
#include "axis/seams/ball_mesh.h"
#include "axis/seams/seam_cells.h"

#include <cstdint>
#include <vector>

namespace medial
{

/// Makes the largest balls in cells where the axis is a curve, as in a tube, and edges between
/// neighbouring ones. Within a fraction of a voxel around a curve all places see the surface under
/// large angles, so that the points of an axis may be there.
/// @param vertices of these cells.
BallMesh ballsOfCurves(const AxisGeometry& geometry, const SeamCells& cells,
  const std::vector<std::uint32_t>& vertices);

} // namespace medial
