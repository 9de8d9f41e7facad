#pragma once

#include "medial/cell_topology.h"
#include "medial/ranks.h"
#include "ranks/axis/rank_part.h"
#include "thinning/voxel_solid.h"

namespace medial
{

/// Computes the topology of a solid that ranks have in pieces, as topologyOf() does in one process.
/// Each rank labels connected parts in its part of the grid, and tells its neighbours the labels
/// of the outermost points; the first rank joins those that meet. Every rank calls it.
/// @param here the solid in this rank's part and a layer around.
/// @return on the first rank; nothing elsewhere.
CellTopology topologyOf(Communicator& communicator, const RankPart& part, const SolidVoxels& here);

} // namespace medial
