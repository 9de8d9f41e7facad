#include "sites/grid_frame.h"

#include <algorithm>

namespace medial
{

GridFrame::GridFrame(const Grid& grid)
  : LocalCoordinates{ {}, *std::min_element(grid.spacing.begin(), grid.spacing.end()) }
{
  for (int axis = 0; axis < 3; ++axis)
  {
    const double cells = grid.dimensions[axis] - 1;
    centre[axis] = grid.origin[axis] + 0.5 * cells * grid.spacing[axis];
    step[axis] = grid.spacing[axis] / unit;
    first[axis] = -0.5 * cells * step[axis];
  }
}

} // namespace medial
