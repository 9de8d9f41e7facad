#pragma once

#include "culling/group_list.h"
#include "medial/grid.h"
#include "sites/grid_frame.h"

#include <glm/glm.hpp>

namespace medial
{

/// Returns the box around the grid points of an extent.
inline FrameBox hullOf(const Extent& extent, const GridFrame& frame)
{
  const glm::dvec3 low(extent.min[0], extent.min[1], extent.min[2]);
  const glm::dvec3 high(extent.max[0], extent.max[1], extent.max[2]);
  return { glm::vec3(frame.sample(0.5 * (low + high))),
    glm::vec3(0.5 * (high - low) * frame.step) };
}

} // namespace medial
