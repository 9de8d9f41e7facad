#pragma once

#include "axis/axis_geometry.h"
#include "axis/seams/ball_mesh.h"
#include "field/crossing.h"

#include <glm/glm.hpp>

#include <vector>

namespace medial
{

/// Makes the sheets of an axis in the grid cells along seams, up to the seams, and its curves. The
/// cells of a MedialAxis have one point for each grid cell, which cannot be on all sheets that meet
/// there.
/// @param crossings those of the axis.
/// @param slices first slice of cells and the end; what is elsewhere is left out.
/// @return local coordinates; all balls have no surface inside.
BallMesh sheetsAtSeams(const AxisGeometry& geometry, const std::vector<Crossing>& crossings,
  const glm::ivec2& slices);

} // namespace medial
