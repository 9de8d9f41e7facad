#pragma once

#include "medial/grid.h"
#include "sign/closed_surface.h"
#include "sites/grid_frame.h"

#include <array>
#include <vector>

namespace medial
{

/// A change of the winding number along a row of grid points.
struct RowCrossing
{
  int row;    ///< index along y
  int point;  ///< first grid point beyond the change; index along x
  int change; ///< 1 where the row enters the solid
};

/// Changes of one slice, by row and then by point.
using SliceCrossings = std::vector<RowCrossing>;

/// Finds where the rows of an extent pass through a closed surface, slice by slice. A row begins
/// outside, so the sum of all changes up to a grid point is the point's winding number. It is exact
/// for points farther from the surface than rounding: neighbouring triangles agree on their shared
/// edge to the last bit, so no row slips through between them. Uses the threads of the current
/// arena.
std::vector<SliceCrossings> rowCrossings(const TriangleChain& surface, const GridFrame& frame,
  const Extent& extent);

/// Appends the changes where the rows of a slice pass through one triangle, as rowCrossings()
/// finds them.
/// @param extent the rows and points that count.
void addCrossings(const std::array<glm::dvec3, 3>& corners, int weight, const GridFrame& frame,
  const Extent& extent, int slice, SliceCrossings& crossings);

/// Sorts the changes of a slice.
void sortCrossings(SliceCrossings& crossings);

} // namespace medial
