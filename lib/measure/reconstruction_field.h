#pragma once

#include "medial/grid.h"

#include <vector>

namespace medial
{

class BallUnion;
class Run;

/// Computes the values of computeReconstruction() in a part of a grid. Where they are less than
/// three voxels away from 0, they are to the last bit those of the whole grid and of all primitives
/// together, provided that the solid has those in reconstructionReach(). Others have the sign of
/// these and are as far away, too.
/// @param extent in the grid; may be empty.
std::vector<float> reconstructionField(const BallUnion& solid, const Grid& grid,
  const Extent& extent, const Run& run);

/// Returns where primitives may have to be that reconstructionField() needs in an extent, which is
/// not empty: primitives that reach nowhere into these bounds change nothing there.
Bounds reconstructionReach(const Grid& grid, const Extent& extent);

} // namespace medial
