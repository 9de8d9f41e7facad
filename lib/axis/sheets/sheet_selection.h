#pragma once

#include "axis/axis_geometry.h"
#include "axis/bisector.h"
#include "axis/dual_mesh.h"
#include "axis/sheets/sheet_fit.h"
#include "axis/sheets/smooth_cells.h"
#include "field/crossing.h"

#include <vector>

// Selection by the separation angle on the bisector. Engines select by the angle between the
// directions at two grid points (Foskey et al. 2003), which differs from it where directions turn
// between them, so they are asked for a smaller angle.
namespace medial
{

/// Returns the angle that engines select by, in the unit of `angle`.
double bandAngle(double angle);

/// The crossings of an axis, with what is known of its sheets beyond their borders.
struct SheetSelection
{
  BisectorPoints bisectors; ///< of the selected crossings
  DualSubmesh part;         ///< their dual mesh, a part of that of the samples
  SheetSamples samples;
  std::vector<std::uint8_t> kept; ///< for each sample not 0 if it is selected
  CellPoints cells;               ///< points of vertices of all samples; may be empty
};

/// Selects the crossings of sheets and curves.
///
/// A crossing of a sheet is selected where the angle, lambda and radius of the sheet are within the
/// limits. Near borders these are those of a SheetFit: facets of a smooth surface make the angle of
/// the bisector jump, and the border would be as jagged. Elsewhere they are its own.
/// Crossings near a curve, which are wide at the grid points only, are moved onto it. Those between
/// smooth cells have their sample in one of these, which costs less than one on the grid edge.
/// @param crossings selected by bandAngle(); only the selected ones stay.
SheetSelection selectSheets(const AxisGeometry& geometry, std::vector<Crossing>& crossings);

/// The same for points without a mesh: all of them have the minimum angle themselves.
BisectorPoints selectPoints(const AxisGeometry& geometry, std::vector<Crossing>& crossings);

} // namespace medial
