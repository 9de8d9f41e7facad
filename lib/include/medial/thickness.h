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

/// What thickness is measured.
struct ThicknessOptions
{
  /// Least separation angle theta of the medial balls that count, in degrees, in (0, 180).
  /// Bisectors of smaller angles, as between the facets of a curved surface, are passed over.
  double angle = kDefaultAngle;
  /// Interior: how thick the solid is. Exterior: how far it is to what is opposite (clearance).
  /// Both: the smaller one. Interior is behind the faces, by their own orientation; a closed,
  /// consistently oriented mesh whose faces point inwards is turned round.
  Side side = Side::Interior;
  Execution execution; ///< threads, progress and cancelling
};

/// Wall thickness, or clearance, of a surface at the points of its mesh.
struct Thickness
{
  /// Per point of the mesh, world units; NaN where there is no medial ball.
  std::vector<float> values;
  double min = 0.0;         ///< of the values that are not NaN; NaN where there are none
  double median = 0.0;      ///< of the same
  double max = 0.0;         ///< of the same
  std::int64_t without = 0; ///< number of NaN
  double seconds = 0.0;     ///< wall-clock

  /// Share of the points without a value, in [0, 1].
  double shareWithout() const
  {
    return values.empty() ? 0.0 : static_cast<double>(without) / static_cast<double>(values.size());
  }
};

/// At every point of a mesh twice the radius of the medial ball that touches it: the ray from the
/// point against its angle-weighted pseudonormal (for exteriors: along it) is followed to the first
/// place x whose closest surface point is seen from x under theta or more away from the ray's
/// start, that is to the first crossing with a bisector of separation angle theta; the radius is
/// the distance there. This is exact for the mesh as it is, in double precision: no grid and no
/// medial axis is involved, nor OpenGL.
///
/// - Where a sheet of the axis runs into the surface the value is 0, as it tends to 0 nearby: on
///   edges that are convex seen from the side and bend by theta or more, and on tips as sharp as
///   that. So the corners of a box have thickness 0; its faces need points to have a value inside.
/// - Edges and tips that bend by less are passed over: their points see the opposite wall.
/// - NaN where there is no such ball: for exteriors of convex parts, where an open mesh has nothing
///   opposite, and at points without a normal (of no triangle, or where those cancel out).
///
/// On a tessellated curved surface the error falls with the square of the facets' size, as that of
/// the tessellation; a little more slowly where the axis is a point. A ball is the slowest case:
/// all its facets are equally near its centre, so that the time grows with the square of their
/// number.
///
/// @throws Error InvalidInput for an empty mesh, an angle outside (0, 180) or negative threads;
///   OutOfMemory; Cancelled.
MEDIAL_EXPORT Thickness computeThickness(const TriangleMesh& mesh,
  const MeshConnectivity& connectivity, const ThicknessOptions& options = {});

/// The same for a mesh whose connectivity the caller has no use for.
MEDIAL_EXPORT Thickness computeThickness(const TriangleMesh& mesh,
  const ThicknessOptions& options = {});

} // namespace medial
