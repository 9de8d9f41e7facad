#pragma once

#include "medial/grid.h"

#include <array>
#include <vector>

namespace medial
{

/// Every how many points of a grid the fields are computed first: once a tile of the processor's.
constexpr int kCoarseStride = 8;

/// The grid of every kCoarseStride-th point of another, from its first; it covers all of it.
Grid coarseGrid(const Grid& grid);

/// Where on a grid the fields of two solids, A and B, can decide on FieldProximity. Distances
/// change by no more than the way between two points, so those on the coarse grid bound all others.
/// @param grid the fine one.
/// @param distances of A and of B at the points of coarseGrid(grid), negative inside. Their signs
///   must change at the surfaces only, as they do for closed meshes and where there are none.
/// @param separation whether the solids' separation is asked for besides their overlap.
/// @returns an extent of whole tiles that has every point inside both, and every point inside one
///   and within half a diagonal of the spacing of the other's surface. Unless some point is sure to
///   be inside both, it also has one, if asked for, where the sum of both distances is least.
///   Otherwise it may be empty.
Extent decisiveExtent(const Grid& grid, const std::array<std::vector<float>, 2>& distances,
  bool separation);

} // namespace medial
