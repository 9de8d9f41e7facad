#pragma once

#include "medial/grid.h"

#include <cstddef>
#include <vector>

namespace medial
{

/// Number of slices of the thickest slabs.
constexpr int kMaxSlices = 64;

/// Returns how many bytes slabs in progress may take.
/// @param memoryMiB as DistanceFieldOptions has it; 0 for a default.
std::size_t slabMemory(std::size_t memoryMiB);

/// Returns the number of slices per slab of an extent: a power of two, as large as memory and an
/// upper limit allow, and at least one.
/// @param bytesPerPoint memory of the slabs in progress, per grid point of a slab.
/// @param memoryMiB as for slabMemory().
int slabSlices(const Extent& extent, std::size_t bytesPerPoint, std::size_t memoryMiB);

/// Returns the slabs in ascending z; the last one may be thinner.
std::vector<Extent> slabsOf(const Extent& extent, int slices);

} // namespace medial
