#pragma once

#include "base/checkpoint.h"
#include "field/crossing.h"
#include "thinning/cubical_complex.h"
#include "thinning/voxel_solid.h"

#include <vector>

namespace medial
{

/// Reduces a solid to its core: those of its voxels where thinning has to decide something. The
/// closed voxels of the solid collapse onto those of the core and the sheets, so that both have the
/// same topology.
///
/// Voxels go in the order of their depths, of equal ones that with the lower index first. One that
/// shares with the sheets and the voxels still there something in one piece and without holes (a
/// simple voxel) collapses onto that, and is gone. The core has the others, the voxels at both ends
/// of crossings, and those in parts as thin as a voxel. A voxel that could not go gets another
/// chance whenever one next to it has gone.
///
/// Most voxels have none of these next to them: what they share with sheets and later voxels
/// decides, which all threads find out at once. Only the others need the order. The core does not
/// depend on the number of threads.
/// @param voxels of the solid; only those of the core stay.
/// @param sheets faces of these voxels, with their edges and corners, which stay for good.
/// @param crossings grid edges whose ends belong to the core where they belong to the solid.
/// @param checkpoint called now and then.
void reduceToCore(const DepthField& depth, const CubicalComplex& sheets,
  const std::vector<Crossing>& crossings, const Checkpoint& checkpoint, VoxelMask& voxels);

} // namespace medial
