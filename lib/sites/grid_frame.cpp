#include "sites/grid_frame.h"

#include <algorithm>

namespace medial
{

GridFrame::GridFrame(const Grid& grid)
  : unit(*std::min_element(grid.spacing.begin(), grid.spacing.end()))
{
  for (int axis = 0; axis < 3; ++axis)
  {
    const double cells = grid.dimensions[axis] - 1;
    centre[axis] = grid.origin[axis] + 0.5 * cells * grid.spacing[axis];
    step[axis] = grid.spacing[axis] / unit;
    first[axis] = -0.5 * cells * step[axis];
  }
}

glm::dvec3 GridFrame::toFrame(const Point3& world) const
{
  return (glm::dvec3(world[0], world[1], world[2]) - centre) / unit;
}

Point3 GridFrame::toWorld(const glm::dvec3& frame) const
{
  const glm::dvec3 world = centre + frame * unit;
  return { world.x, world.y, world.z };
}

} // namespace medial
