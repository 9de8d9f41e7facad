#pragma once

#include "axis/axis_geometry.h"
#include "axis/bisector.h"
#include "axis/dual_mesh.h"
#include "axis/sheets/sheet_selection.h"

namespace medial
{

/// Places every vertex of the dual mesh where the bisectors of its cell meet, by a quadratic error
/// function over their planes. If the separation angle is too small there, it tries
/// axisAlongNormals(), then the nearest crossing of the cell, so that all vertices have the angle.
///
/// @param known points that smooth cells have already.
/// @param origins for each vertex that of the known points, or kNoVertex.
BisectorPoints surfacePoints(const AxisGeometry& geometry, const DualMesh& mesh,
  const BisectorPoints& bisectors, const CellPoints& known,
  const std::vector<std::size_t>& origins);

/// The same for the dual mesh of selected crossings.
BisectorPoints surfacePoints(const AxisGeometry& geometry, const SheetSelection& selection);

/// Places every vertex at the centre of its cell.
BisectorPoints cellCentres(const AxisGeometry& geometry, const DualMesh& mesh,
  const BisectorPoints& bisectors);

} // namespace medial
