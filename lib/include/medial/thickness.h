#pragma once

#include "medial/default_angle.h"
#include "medial/execution.h"
#include "medial/export.h"
#include "medial/mesh_connectivity.h"
#include "medial/side.h"
#include "medial/triangle_mesh.h"

#include <algorithm>
#include <cstdint>
#include <vector>

namespace medial
{

/// What thickness is.
enum class ThicknessMethod
{
  /// Twice the radius of the medial ball that touches the place. It falls to 0 at convex edges.
  Ball,
  /// Distance to the opposite surface, straight into the solid along the normal, as CAD programs
  /// measure it. Where the walls are not parallel, it is more than the wall has.
  Ray,
  /// Diameter of the ball that also touches the opposite wall: its separation angle is at least 120
  /// degrees. Where there is no such ball, as near the edges of a plate, the value is that of the
  /// nearest place on the surface that has one, but not beyond the foot of a rib. The border of
  /// another face right beside the place, as where a surface is not welded, is no opposite wall.
  Wall
};

/// Minimum separation angle, degrees, of the balls of ThicknessMethod::Wall.
constexpr double kMinWallAngle = 120.0;

/// How thickness is measured.
struct ThicknessOptions
{
  /// Minimum separation angle theta of the medial balls that count, in degrees, in (0, 180).
  /// Bisectors with smaller angles, such as those between facets of a curved surface, are ignored.
  /// Walls take 120 if it is less; rays ignore it.
  double angle = kDefaultAngle;
  /// Interior: the thickness of the solid. Exterior: the distance to the opposite surface
  /// (clearance). Both: the smaller of the two. The interior is behind the faces, by their own
  /// orientation; a closed, consistently oriented mesh whose faces point inwards is reversed first.
  Side side = Side::Interior;
  /// What thickness is.
  ThicknessMethod method = ThicknessMethod::Ball;
  /// Whether to compute values for triangles too, and atEdge for all values, as
  /// findThicknessRegions() needs. Takes about three times as long.
  bool cells = false;
  Execution execution; ///< threads, progress and cancelling

  /// Minimum separation angle, degrees, that the method's balls do have; rays have no balls.
  double ballAngle() const
  {
    return method == ThicknessMethod::Wall ? std::max(angle, kMinWallAngle) : angle;
  }
};

/// Wall thickness, or clearance, of a surface at the points of its mesh.
struct Thickness
{
  /// Per point of the mesh, world units; NaN where there is no medial ball.
  std::vector<float> values;
  /// Per triangle, the same at its centre; empty unless ThicknessOptions::cells is on.
  std::vector<float> triangleValues;
  /// Per point, 1 where the solid is thin only because two of its sides meet at a convex edge or
  /// tip nearby. That is where the planes that touch the ball, or that the ray starts and ends at,
  /// meet at more than 60 degrees; or at 15 degrees or more, and where they meet is an edge that
  /// bends by 60 degrees (theta, if that is less) or more, or an equally sharp tip, within a
  /// quarter of the distance there. Otherwise 0. Empty unless ThicknessOptions::cells is on.
  std::vector<char> atEdge;
  /// The same per triangle.
  std::vector<char> triangleAtEdge;
  double min = 0.0;          ///< smallest of the values that are not NaN; NaN if there are none
  double percentile5 = 0.0;  ///< 5 % of the same values, and no more, are smaller
  double median = 0.0;       ///< median of the same values
  double percentile95 = 0.0; ///< 5 % of the same values, and no more, are larger
  double max = 0.0;          ///< largest of the same values
  std::int64_t points = 0;   ///< number of points of the surface: of several ranks, of the whole
  std::int64_t without = 0;  ///< number of those without a value (NaN)
  double seconds = 0.0;      ///< wall-clock time

  /// Share of the points without a value, in [0, 1].
  double shareWithout() const
  {
    return points == 0 ? 0.0 : static_cast<double>(without) / static_cast<double>(points);
  }
};

/// Computes the thickness at every point of a mesh.
///
/// ThicknessMethod::Ball is twice the radius of the medial ball that touches the surface there. A
/// ray starts at the point, against its angle-weighted pseudonormal (for exteriors along it). It
/// ends at its first crossing with a bisector of separation angle theta: the first place from which
/// the closest surface point and the ray's start are seen at least theta apart. The radius is the
/// distance to the surface there. This is exact for the mesh as it is, in double precision; it
/// needs no grid, no medial axis and no OpenGL.
///
/// - Where a sheet of the axis ends at the surface the value is 0, since thickness tends to 0
///   nearby: on edges that bend by theta or more and are convex seen from the side, and on equally
///   sharp tips. So the corners of a box have thickness 0; its faces have a thickness only at
///   points inside them.
/// - Edges and tips that bend by less are ignored: their points see the opposite wall.
/// - NaN where there is no such ball: at exteriors of convex parts, where an open mesh has no
///   opposite surface, and at points without a normal (of no triangle, or where the normals cancel
///   out). Also where theta excludes the ball that touches: within half its height of the edges of
///   a plate, balls touch two sides at 90 degrees, so above 90 there is none. Only surfaces that
///   are seen under less than theta and less than 60 degrees, as on a tessellated curve, may be
///   nearer to the ball's centre than the point; others by 5 % at most.
///
/// ThicknessMethod::Ray is the distance to the first triangle that the same ray meets. On edges
/// that are convex seen from the side and bend by 60 degrees or more, and equally sharp tips, it is
/// the least of what the rays of the faces that meet there tend to. NaN where a ray meets nothing.
/// Segments and points stop no ray.
///
/// ThicknessMethod::Wall takes the ball for theta of 120 degrees or more. Other surfaces may be
/// nearer to its centre than the place, down to 0.8 times the distance; the value is then the way
/// through the centre to the wall. Places without such a ball, and those on edges that are convex
/// and bend by 60 degrees or more, take the value of the nearest place with one, along the edges of
/// the mesh, where distances count in multiples of the value, up to 1.5, and no further than edges
/// where the solid opens by 30 degrees or more. NaN elsewhere, as on tetrahedra.
///
/// On a tessellated curved surface the error falls with the square of the facets' size, as that of
/// the tessellation does; a little more slowly where the axis is a point. A ball is the slowest
/// case: all its facets are equally near its centre, so the time grows with the square of their
/// number.
///
/// @return one value per point of the mesh, their minimum, median and maximum, and the percentiles
/// 5 and 95.
/// @throws Error InvalidInput for an empty mesh, an angle outside (0, 180) or a negative number of
///   threads; OutOfMemory; Cancelled.
MEDIAL_EXPORT Thickness computeThickness(const TriangleMesh& mesh,
  const MeshConnectivity& connectivity, const ThicknessOptions& options = {});

/// The same for callers that do not need the connectivity of the mesh.
MEDIAL_EXPORT Thickness computeThickness(const TriangleMesh& mesh,
  const ThicknessOptions& options = {});

} // namespace medial
