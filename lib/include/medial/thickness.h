#pragma once

#include "medial/default_angle.h"
#include "medial/execution.h"
#include "medial/export.h"
#include "medial/mesh_connectivity.h"
#include "medial/side.h"
#include "medial/triangle_mesh.h"

#include <cstdint>
#include <vector>

namespace medial
{

/// How thickness is measured.
struct ThicknessOptions
{
  /// Minimum separation angle theta of the medial balls that count, in degrees, in (0, 180).
  /// Bisectors with smaller angles, such as those between facets of a curved surface, are ignored.
  double angle = kDefaultAngle;
  /// Interior: the thickness of the solid. Exterior: the distance to the opposite surface
  /// (clearance). Both: the smaller of the two. The interior is behind the faces, by their own
  /// orientation; a closed, consistently oriented mesh whose faces point inwards is reversed first.
  Side side = Side::Interior;
  Execution execution; ///< threads, progress and cancelling
};

/// Wall thickness, or clearance, of a surface at the points of its mesh.
struct Thickness
{
  /// Per point of the mesh, world units; NaN where there is no medial ball.
  std::vector<float> values;
  double min = 0.0;         ///< smallest of the values that are not NaN; NaN if there are none
  double median = 0.0;      ///< median of the same values
  double max = 0.0;         ///< largest of the same values
  std::int64_t without = 0; ///< number of points without a value (NaN)
  double seconds = 0.0;     ///< wall-clock time

  /// Share of the points without a value, in [0, 1].
  double shareWithout() const
  {
    return values.empty() ? 0.0 : static_cast<double>(without) / static_cast<double>(values.size());
  }
};

/// Computes the thickness at every point of a mesh: twice the radius of the medial ball that
/// touches the surface there. A ray starts at the point, against its angle-weighted pseudonormal
/// (for exteriors along it). It ends at its first crossing with a bisector of separation angle
/// theta: the first place x from which the closest surface point and the ray's start are seen at
/// theta or more from each other. The radius is the distance to the surface there. This is exact
/// for the mesh as it is, in double precision; it needs no grid, no medial axis and no OpenGL.
///
/// - Where a sheet of the axis ends at the surface the value is 0, as thickness tends to 0 nearby:
///   on edges that bend by theta or more and are convex seen from the side, and on equally sharp
///   tips. So the corners of a box have thickness 0; its faces have a thickness only at points
///   inside them.
/// - Edges and tips that bend by less are ignored: their points see the opposite wall.
/// - NaN where there is no such ball: at exteriors of convex parts, where an open mesh has no
///   opposite surface, and at points without a normal (of no triangle, or where the normals cancel
///   out). Also where theta excludes the ball that touches: within half its height of the edges of
///   a plate, balls touch two sides at 90 degrees, so above 90 there is none. Only surfaces that
///   are seen under less than theta and less than 60 degrees, as on a tessellated curve, may be
///   nearer to the ball's centre than the point; others by 5 % at most.
///
/// On a tessellated curved surface the error falls with the square of the facets' size, as that of
/// the tessellation does; a little more slowly where the axis is a point. A ball is the slowest
/// case: all its facets are equally near its centre, so the time grows with the square of their
/// number.
///
/// @return one value per point of the mesh, and their minimum, median and maximum.
/// @throws Error InvalidInput for an empty mesh, an angle outside (0, 180) or a negative number of
///   threads; OutOfMemory; Cancelled.
MEDIAL_EXPORT Thickness computeThickness(const TriangleMesh& mesh,
  const MeshConnectivity& connectivity, const ThicknessOptions& options = {});

/// The same for callers that do not need the connectivity of the mesh.
MEDIAL_EXPORT Thickness computeThickness(const TriangleMesh& mesh,
  const ThicknessOptions& options = {});

} // namespace medial
