#pragma once

#include "axis/axis_geometry.h"
#include "axis/bisector.h"
#include "axis/dual_mesh.h"
#include "axis/smooth_cells.h"

namespace medial
{

/// Places every vertex of the dual mesh where the bisectors of its cell meet, by a quadratic error
/// function over their planes. If the separation angle is too small there, it tries
/// axisAlongNormals(), then the nearest crossing of the cell, so that all vertices have the angle.
/// @param known points of some vertices; may be empty.
BisectorPoints surfacePoints(const AxisGeometry& geometry, const DualMesh& mesh,
  const BisectorPoints& bisectors, const CellPoints& known = {});

/// Places every vertex at the centre of its cell.
BisectorPoints cellCentres(const AxisGeometry& geometry, const DualMesh& mesh,
  const BisectorPoints& bisectors);

} // namespace medial
