#pragma once

#include "axis/axis_geometry.h"
#include "axis/bisector_point.h"
#include "field/crossing.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <optional>
#include <vector>

// All of this takes many segments or points at a time, since closest points are cheaper together.
namespace medial
{

/// A segment and the closest sites at its ends.
struct SiteSegment
{
  glm::dvec3 from;
  int fromSite;
  glm::dvec3 to;
  int toSite;
};

/// The grid edge of a crossing.
SiteSegment segmentOf(const GridFrame& frame, const Crossing& crossing);

/// Of each segment, the point at equal distance from the closest site at its start and that at its
/// end.
///
/// Where a third site is nearer there than the two, the segment is narrowed to the change from or
/// to this site, whichever has the larger separation angle.
std::vector<BisectorPoint> bisectorPoints(const AxisGeometry& geometry,
  const std::vector<SiteSegment>& segments);

/// Follows the normal of each point's closest point to the next bisector that has the least
/// separation angle, at most h/(2 sin(theta/2)) + h/2 away: so far selection by neighbouring grid
/// points errs.
std::vector<std::optional<BisectorPoint>> axisAlongNormals(const AxisGeometry& geometry,
  const std::vector<BisectorPoint>& points);

/// A point for each of a list of crossings.
struct BisectorPoints
{
  std::vector<BisectorPoint> points;
  /// Where the bisector on the grid edge has too small a separation angle and that along the normal
  /// stands for it: fins around curves.
  std::vector<std::uint8_t> moved;
};

/// The bisector point of every crossed grid edge. Crossings below the limits of lambda and radius
/// are removed, and those that meet the surface itself, where an edge grazes it and the field is
/// unsigned.
/// @param exactAngle whether the separation angle is limited as well, by axisAlongNormals() or
///   removal. Where facets approximate a round surface, so that neighbours are closest, `b` may be
///   a tenth of a grid step farther than `a` to have that angle.
BisectorPoints crossingPoints(const AxisGeometry& geometry, bool exactAngle,
  std::vector<Crossing>& crossings);

} // namespace medial
