#pragma once

#include "axis/axis_geometry.h"
#include "axis/bisector.h"
#include "axis/dual_mesh.h"

namespace medial
{

/// Places every vertex of the dual mesh where the bisectors of its cell meet, by a quadratic error
/// function over their planes. Where the separation angle is too small there, axisAlongNormal() is
/// tried, then the nearest crossing of the cell, so that all vertices have it.
BisectorPoints surfacePoints(const AxisGeometry& geometry, const DualMesh& mesh,
  const BisectorPoints& bisectors);

/// The centres of the cells.
BisectorPoints cellCentres(const AxisGeometry& geometry, const DualMesh& mesh,
  const BisectorPoints& bisectors);

} // namespace medial
