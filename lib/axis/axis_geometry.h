#pragma once

#include "axis/side_check.h"
#include "base/checkpoint.h"
#include "culling/site_query.h"
#include "sites/grid_frame.h"
#include "sites/site_set.h"

#include <algorithm>
#include <cmath>

namespace medial
{

/// What points of an axis must have at least; local units.
struct AxisLimits
{
  double angle;        ///< separation angle, radians
  double lambda = 0.0; ///< BisectorPoint::lambda()
  double radius = 0.0;
};

/// The input of an axis and the limits that its points must meet; local units.
struct AxisGeometry
{
  const SiteSet& sites;
  const SiteQuery& query;
  const GridFrame& frame;
  Extent extent; ///< the whole grid
  Extent part;   ///< of the grid, where crossings are
  AxisLimits limits;
  const Checkpoint& checkpoint; ///< for loops over points
  /// Null without a sign, when points may be anywhere.
  const SideCheck* side = nullptr;

  /// Whether a point is on another side of the surface than one that it was found from.
  /// @param reach see SideCheck.
  bool isAcross(const glm::dvec3& known, double reach, const BisectorPoint& point) const
  {
    return side != nullptr && side->isAcross(known, reach, point);
  }

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

  /// Returns the grid cell at x, or the nearest one of the part.
  glm::ivec3 cellAt(const glm::dvec3& x) const
  {
    glm::ivec3 cell;
    for (int axis = 0; axis < 3; ++axis)
    {
      const double index = std::floor((x[axis] - frame.first[axis]) / frame.step[axis]);
      cell[axis] = static_cast<int>(std::clamp<double>(index, part.min[axis], part.max[axis]));
    }
    return cell;
  }
};

} // namespace medial
