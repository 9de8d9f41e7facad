#pragma once

#include "base/checkpoint.h"
#include "culling/site_query.h"
#include "sites/grid_frame.h"
#include "sites/site_set.h"

namespace medial
{

/// The input of an axis and the limits that its points must meet; local units.
struct AxisGeometry
{
  const SiteSet& sites;
  const SiteQuery& query;
  const GridFrame& frame;
  Extent extent;
  double angle;                 ///< minimum separation angle, radians
  double lambda;                ///< minimum BisectorPoint::lambda()
  double radius;                ///< minimum radius
  const Checkpoint& checkpoint; ///< for loops over points

  /// Whether queries at x are exact.
  bool insideGrid(const glm::dvec3& x) const
  {
    const glm::dvec3 index = (x - frame.first) / frame.step;
    for (int axis = 0; axis < 3; ++axis)
    {
      if (index[axis] < extent.min[axis] || index[axis] > extent.max[axis])
      {
        return false;
      }
    }
    return true;
  }
};

} // namespace medial
