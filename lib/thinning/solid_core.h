#pragma once

#include "base/checkpoint.h"
#include "field/crossing.h"
#include "thinning/cubical_complex.h"
#include "thinning/sparse_voxels.h"
#include "thinning/voxel_solid.h"

#include <cstddef>
#include <vector>

namespace medial
{

/// Returns the core of a solid in a whole grid: those of its voxels where thinning has to decide
/// something. The closed voxels of the solid collapse onto those of the core and the sheets, so
/// that both have the same topology.
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
/// @param sheets faces of the voxels, with their edges and corners, which stay for good.
/// @param crossings grid edges whose ends belong to the core where they belong to the solid.
/// @param checkpoint called now and then.
/// @return positions of the voxels, ascending.
std::vector<std::size_t> coreOf(const SolidVoxels& solid, const CubicalComplex& sheets,
  const std::vector<Crossing>& crossings, const Checkpoint& checkpoint);

/// The same of a solid whose undecided voxels are known: looks at few others.
/// @param voxels as they are loaded.
/// @param undecided of the whole grid, ascending; see undecidedVoxels().
std::vector<std::size_t> coreOf(SparseVoxels& voxels, const CubicalComplex& sheets,
  const std::vector<Crossing>& crossings, const std::vector<std::size_t>& undecided,
  const Checkpoint& checkpoint);

} // namespace medial
