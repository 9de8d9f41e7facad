#pragma once

#include "base/checkpoint.h"
#include "thinning/cubical_complex.h"
#include "thinning/voxel_solid.h"

#include <cstddef>
#include <vector>

namespace medial
{

/// Returns the voxels of a solid in a part of the grid that need the order in which voxels go
/// (coreOf()), or the way up to deeper ones: those that what they share with sheets and later
/// voxels does not let go, and those of parts as thin as a voxel. All threads look for them.
/// @param voxels of the solid: voxelsOf().
/// @param sheets in the part.
/// @return positions in the part, ascending. Those in its outer layers are left out.
std::vector<std::size_t> undecidedVoxels(const SolidVoxels& solid, const VoxelMask& voxels,
  const CubicalComplex& sheets, const Checkpoint& checkpoint);

} // namespace medial
