#pragma once

#include "axis/axis_geometry.h"
#include "axis/bisector_point.h"
#include "field/crossing.h"

#include <glm/glm.hpp>

#include <array>
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
  double change = -1.0; ///< about where one changes to the other, as a share; -1 if unknown
};

/// Returns the grid edge of a crossing.
SiteSegment segmentOf(const GridFrame& frame, const Crossing& crossing);

/// Whether a point that was found on a segment is on another side of the surface than its ends.
bool isBeyondSurface(const AxisGeometry& geometry, const SiteSegment& segment,
  const BisectorPoint& point);

/// For each segment, finds the point at equal distance from the closest sites of its two ends.
///
/// If a third site is nearer there than these two, the segment is narrowed to the change from or to
/// that site, whichever has the larger separation angle.
std::vector<BisectorPoint> bisectorPoints(const AxisGeometry& geometry,
  const std::vector<SiteSegment>& segments);

/// Follows the normal of each point's closest point to the next bisector on the same side of the
/// surface with the minimum separation angle, at most h/(2 sin(theta/2)) + h/2 away: the error of
/// selection by neighbouring grid points is no larger.
std::vector<std::optional<BisectorPoint>> axisAlongNormals(const AxisGeometry& geometry,
  const std::vector<BisectorPoint>& points);

/// Sites up to this much (voxels) farther away than the closest one count if the closest ones have
/// too small a separation angle: all facets of a round surface have bisectors of their own, which
/// part at its centre.
constexpr double kFacets = 0.1;
/// Medial balls smaller than this (voxels) belong to the surface itself.
constexpr double kMinRadius = 1e-3;

/// A third site counts as nearer from this difference on (voxels).
constexpr double kSameDistance = 1e-6;

/// Asks for the closest point at a bisector point.
SiteQuery::Question questionAt(const BisectorPoint& point);
/// Whether the two points of a bisector point are its closest pair: whether the closest point there
/// is no nearer.
bool isClosestPair(const BisectorPoint& point, const SitePoint& closest);

/// A point for each of a list of crossings.
struct BisectorPoints
{
  std::vector<BisectorPoint> points;
  /// Marks fins around curves: the bisector on the grid edge has too small a separation angle, and
  /// the one along the normal replaces it.
  std::vector<std::uint8_t> moved;
};

/// Finds the points at equal distance from both sites of each segment, even if others are nearer by
/// up to kFacets. Nothing if another site is nearer than that, or if the separation angle
/// is below `minAngle`, radians.
std::vector<std::optional<BisectorPoint>> facetedPoints(const AxisGeometry& geometry,
  const std::vector<SiteSegment>& segments, double minAngle);

/// Finds bisector points on segments with sites near their ends. Nothing if both ends turn out to
/// have the same closest site, or if one is outside the grid.
std::vector<std::optional<BisectorPoint>> bisectorsOn(const AxisGeometry& geometry,
  std::vector<SiteSegment> segments);

/// Finds the bisector points of the sites of segments, which are mostly the closest ones: one query
/// for each instead of three.
/// @param open set to the numbers of those where other sites are nearer: there the closest point
///   counts twice.
std::vector<BisectorPoint> guessedBisectors(const AxisGeometry& geometry,
  const std::vector<SiteSegment>& segments, std::vector<std::size_t>& open);

/// Finds the closest points to the middles between pairs of points.
/// @param begin numbers of the points of each pair.
std::vector<SiteQuery::Question> closestToMiddles(const AxisGeometry& geometry,
  const std::vector<BisectorPoint>& points, const std::array<std::uint32_t, 2>* begin,
  const std::array<std::uint32_t, 2>* end);

/// Finds the guessed bisector points of segments inside the grid, and those on the others as
/// bisectorsOn() does.
std::vector<std::optional<BisectorPoint>> bisectorsNear(const AxisGeometry& geometry,
  const std::vector<SiteSegment>& segments);

/// Finds the bisector point of every crossed grid edge. Removes crossings below the limits of
/// lambda and radius, those on the surface itself, where an edge grazes it and the field is
/// unsigned, and those beyond the surface.
BisectorPoints crossingPoints(const AxisGeometry& geometry, std::vector<Crossing>& crossings);

} // namespace medial
