#pragma once

#include "medial/culling/tile_query.h"
#include "medial/medial/crossing.h"
#include "medial/sites/site_set.h"

#include <glm/glm.hpp>

#include <vector>

namespace medial
{

/// A point with two closest surface points; frame coordinates.
struct BisectorPoint
{
  glm::dvec3 position{ 0.0 };
  SitePoint a;
  SitePoint b;

  double radius() const { return glm::distance(position, a.point); }
  /// Half the distance of the closest points: radius * sin(separation angle / 2).
  double lambda() const { return 0.5 * glm::distance(a.point, b.point); }
  /// Radians.
  double separationAngle() const;
  /// Unit normal of the bisector, or zero where both closest points are one.
  glm::dvec3 normal() const;
};

/// What a point of the medial axis must have; frame units.
struct AxisLimits
{
  double radius = 0.0;
  double lambda = 0.0;
};

/// The point of a segment at equal distance from the closest site at its start and that at its end.
///
/// Where a third site is nearer there than the two, the segment is narrowed to the change from or
/// to this site, whichever has the larger separation angle.
/// @param fromSite closest site at `from`; toSite: at `to`.
BisectorPoint bisectorPoint(const SiteSet& sites, const TileQuery& query, const glm::dvec3& from,
  int fromSite, const glm::dvec3& to, int toSite);

/// bisectorPoint() of every crossed grid edge. Crossings below the limits are removed, and those
/// that meet the surface itself, where an edge grazes it and the field is unsigned.
std::vector<BisectorPoint> bisectorPoints(const SiteSet& sites, const GridFrame& frame,
  const TileQuery& query, const AxisLimits& limits, std::vector<Crossing>& crossings);

} // namespace medial
