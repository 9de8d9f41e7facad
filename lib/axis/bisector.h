#pragma once

#include "axis/axis_geometry.h"
#include "axis/bisector_point.h"
#include "field/crossing.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <optional>
#include <vector>

// These functions take many segments or points at once, since this makes closest points cheaper.
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

/// Returns the grid edge of a crossing.
SiteSegment segmentOf(const GridFrame& frame, const Crossing& crossing);

/// For each segment, finds the point at equal distance from the closest sites of its two ends.
///
/// If a third site is nearer there than these two, the segment is narrowed to the change from or to
/// that site, whichever has the larger separation angle.
std::vector<BisectorPoint> bisectorPoints(const AxisGeometry& geometry,
  const std::vector<SiteSegment>& segments);

/// Follows the normal of each point's closest point to the next bisector with the minimum
/// separation angle, at most h/(2 sin(theta/2)) + h/2 away: the error of selection by neighbouring
/// grid points is no larger.
std::vector<std::optional<BisectorPoint>> axisAlongNormals(const AxisGeometry& geometry,
  const std::vector<BisectorPoint>& points);

/// A point for each of a list of crossings.
struct BisectorPoints
{
  std::vector<BisectorPoint> points;
  /// Marks fins around curves: the bisector on the grid edge has too small a separation angle, and
  /// the one along the normal replaces it.
  std::vector<std::uint8_t> moved;
};

/// Finds the bisector point of every crossed grid edge. Removes crossings below the limits of
/// lambda and radius, and those on the surface itself, where an edge grazes it and the field is
/// unsigned.
/// @param exactAngle whether to limit the separation angle as well, by axisAlongNormals() or
///   removal. Where facets approximate a round surface, so that neighbouring facets are closest,
///   `b` may be a tenth of a grid step farther away than `a` to have that angle.
BisectorPoints crossingPoints(const AxisGeometry& geometry, bool exactAngle,
  std::vector<Crossing>& crossings);

} // namespace medial
