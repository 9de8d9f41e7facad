#pragma once

#include "axis/axis_geometry.h"
#include "axis/bisector.h"
#include "field/crossing.h"
#include "medial/cell_topology.h"
#include "medial/representation.h"
#include "medial/side.h"
#include "medial/sign_method.h"
#include "thinning/thinned_axis.h"

#include <cstdint>
#include <vector>

namespace medial
{

/// An axis with the topology of its solid.
struct PreservedAxis
{
  ThinnedAxis cells;
  CellTopology solid;
};

/// What is to be thinned, with the field at all grid points, x fastest.
struct ThinningInput
{
  const float* distances; ///< world units
  const std::int32_t* closestSites;
  SignMethod sign;
  Side side; ///< Both where there is no sign
  Representation representation;
};

/// Thins the voxels of each wanted side to an axis of the same topology (Thinning), anchored at
/// the faces dual to the crossings that were selected, but for those that make no sheet.
///
/// Needs 10 bytes a grid point with the field, and what the fire's front takes.
/// @param crossings selected, with their bisector points.
PreservedAxis preserveTopology(const ThinningInput& input, const AxisGeometry& geometry,
  const std::vector<Crossing>& crossings, const BisectorPoints& bisectors);

} // namespace medial
