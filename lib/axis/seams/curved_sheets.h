#pragma once

#include "axis/axis_geometry.h"
#include "axis/bisector_point.h"
#include "axis/seams/ball_mesh.h"
#include "medial/medial_axis.h"

#include <vector>

namespace medial
{

/// Divides the triangles of an axis where its sheets are so curved that balls between two corners,
/// whose radius is linear between them, are noticeably smaller than those of the sheet.
/// @param points of the axis.
/// @param axis its quads count as two triangles.
/// @return the parts of divided triangles; local coordinates. All balls have no surface inside.
BallMesh divideCurvedSheets(const AxisGeometry& geometry, std::vector<BisectorPoint> points,
  const MedialAxis& axis);

} // namespace medial
