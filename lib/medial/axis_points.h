#pragma once

#include "medial/culling/tile_query.h"
#include "medial/medial/bisector.h"
#include "medial/medial/dual_mesh.h"
#include "medial/sites/grid_frame.h"
#include "medial/sites/site_set.h"

#include <cstdint>
#include <vector>

namespace medial
{

/// What the geometry of an axis is made from.
struct AxisGeometry
{
  const SiteSet& sites;
  const TileQuery& query;
  const GridFrame& frame;
  Extent extent;
  double angle; ///< least separation angle, radians
};

/// Vertices of the dual mesh with their two closest points.
struct AxisPoints
{
  std::vector<BisectorPoint> points;
  /// True for points that had too small a separation angle where their cell's crossings put them
  /// and were moved to the axis nearby: fins around curves, and rims.
  std::vector<std::uint8_t> moved;
};

/// Places every vertex where the bisectors of its cell meet, by a quadratic error function over
/// their planes. A vertex whose separation angle is too small then follows the normal of its closest
/// point to the next bisector that has it, at most h/(2 sin(theta/2)) + h/2 away, which is how far
/// selection by neighbouring grid points errs.
AxisPoints surfacePoints(const AxisGeometry& geometry, const DualMesh& mesh,
  const std::vector<BisectorPoint>& bisectors);

/// The centres of the cells.
AxisPoints cellCentres(const AxisGeometry& geometry, const DualMesh& mesh,
  const std::vector<BisectorPoint>& bisectors);

} // namespace medial
