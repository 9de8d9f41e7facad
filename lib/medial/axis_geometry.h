#pragma once

#include "medial/common/checkpoint.h"
#include "medial/culling/tile_query.h"
#include "medial/sites/grid_frame.h"
#include "medial/sites/site_set.h"

namespace medial
{

/// What an axis is made from, and what its points must have; frame units.
struct AxisGeometry
{
  const SiteSet& sites;
  const TileQuery& query;
  const GridFrame& frame;
  Extent extent;
  double angle;                 ///< least separation angle, radians
  double lambda;                ///< least BisectorPoint::lambda()
  double radius;                ///< least radius
  const Checkpoint& checkpoint; ///< for loops over points
};

} // namespace medial
