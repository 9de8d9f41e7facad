#pragma once

#include "medial/grid.h"

#include <cstddef>
#include <vector>

namespace medial
{

/// Slices of the slabs that an extent is computed in: a power of two, as many as memory allows up
/// to a limit, and at least one.
/// @param bytesPerPoint that the slabs in work at a time take for each grid point of a slab.
/// @param memoryMiB what they should not exceed; 0 for a default.
int slabSlices(const Extent& extent, std::size_t bytesPerPoint, std::size_t memoryMiB);

/// The slabs in ascending z; the last one may be thinner.
std::vector<Extent> slabsOf(const Extent& extent, int slices);

} // namespace medial
