#pragma once

#include "base/checkpoint.h"
#include "skeleton/curve_fire.h"
#include "skeleton/sheet_fire.h"

#include <cstdint>
#include <vector>

namespace medial
{

/// Finds the curves to keep among the edges that a fire has left of the sheets, so that the network
/// has the components and the loops of those edges. Only loops that leave the solid are opened:
/// voxels touch across a narrow gap there.
///
/// What is left after burnCurves() ends where the width begins to grow by less than half of the
/// length. Of branches that are too short to tell, those go first that the fire has burned soonest,
/// so that the others become longer. Branches shorter than NetworkInput::minBranch go, the shortest
/// at a junction first.
/// @param vertices points of the axis of no edge.
/// @return curves from junction to junction or free end.
std::vector<CurvePath> curveNetwork(const std::vector<NetworkEdge>& edges,
  const std::vector<std::int64_t>& vertices, const NetworkInput& input,
  const Checkpoint& checkpoint);

} // namespace medial
