#pragma once

#include "medial/distance_field.h"
#include "medial/export.h"
#include "medial/grid.h"
#include "medial/mesh_connectivity.h"
#include "medial/run_statistics.h"
#include "medial/side.h"
#include "medial/triangle_mesh.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace medial
{

/// How local thickness is computed.
struct LocalThicknessOptions
{
  /// Interior: the thickness of the solid, and 0 outside. Exterior: the separation, which is the
  /// same of the space outside, and 0 inside; a positive number as well. Both: the thickness
  /// inside, and outside the separation as a negative number.
  Side side = Side::Interior;
  /// Number of bins of LocalThicknessSummary::histogram, in [1, 65536].
  int bins = 64;
  DistanceFieldOptions field; ///< how the distance field behind it is computed
};

/// The local thickness, or the separation, of all grid points on one side.
struct LocalThicknessSummary
{
  std::int64_t points = 0; ///< grid points on this side
  double min = 0.0;        ///< smallest value, world units; NaN without points, as the others
  double mean = 0.0;       ///< mean over these grid points, world units
  double standardDeviation = 0.0; ///< root of the mean square difference from the mean, world units
  double max = 0.0;               ///< largest value, world units
  /// How many of the points have a value in each of equally wide bins from 0 to `end`.
  std::vector<std::int64_t> histogram;
  double end = 0.0; ///< where the last bin ends, world units, at least `max`
};

/// What was found out about local thickness besides its values.
struct LocalThicknessStatistics
{
  std::optional<LocalThicknessSummary> thickness;  ///< with Side::Interior and Side::Both
  std::optional<LocalThicknessSummary> separation; ///< with Side::Exterior and Side::Both
  std::int64_t balls = 0; ///< centres of inscribed balls that the values are made from
  double seconds = 0.0;   ///< wall-clock time, without that of `field`
  RunStatistics field;    ///< the distance field and the medial axis behind them
};

/// Local thickness in memory.
struct LocalThickness
{
  Grid grid;                           ///< its grid
  std::vector<float> values;           ///< one per grid point, x fastest, world units
  LocalThicknessStatistics statistics; ///< their distribution
};

/// Computes the local thickness of a solid at every point of a grid: the diameter of the largest
/// ball inside the solid that contains the point (Hildebrand, Rueegsegger 1997), in world units.
///
/// The centres of the balls lie anywhere in the box of the grid, not only on its points: they are
/// points of the medial axis with their exact radii, and between neighbouring ones, along edges and
/// within triangles, which are divided where the axis is curved, the radius is linear. Where the
/// grid cuts a solid, or the space around one, balls have their centres within the grid, but need
/// not lie in it. Values are rounded to 1/256 of the finest spacing. Balls with a separation angle
/// below 25 degrees are left out, as those between the facets of a round surface; points in no
/// other ball get the one next to them if that is within 2.5 % of its radius. Points in tips that
/// are thinner than the spacing, and those within 1/16 voxel of the surface, look for the largest
/// ball themselves. Other such details may be missed; their points then have at least twice their
/// own distance to the surface.
///
/// @param values receives one number per grid point, x fastest, as LocalThicknessOptions::side
///   says. No other array of the size of the grid is made.
/// @throws Error InvalidInput if the mesh does not define an inside, for bins outside their
///   range, and as computeDistanceField; OutOfMemory; Cancelled.
MEDIAL_EXPORT LocalThicknessStatistics computeLocalThickness(const TriangleMesh& mesh,
  const MeshConnectivity& connectivity, const Grid& grid, float* values,
  const LocalThicknessOptions& options = {});

/// The same, but delivers the values slab by slab, for grids that do not fit into memory. The
/// distances that this needs take about a byte for each grid point on the side; where this is more
/// than half of DistanceFieldOptions::memoryMiB, the distance field is computed once more.
/// @param sink receives the values in FieldArrays::distance, the only array that it may want.
/// @param field receives the distance field, as computeDistanceField() delivers it, before `sink`
///   receives anything; may be null. It costs less than another call.
MEDIAL_EXPORT LocalThicknessStatistics computeLocalThickness(const TriangleMesh& mesh,
  const MeshConnectivity& connectivity, const Grid& grid, FieldSink& sink,
  const LocalThicknessOptions& options = {}, FieldSink* field = nullptr);

/// The same for callers that do not need the connectivity of the mesh.
MEDIAL_EXPORT LocalThickness computeLocalThickness(const TriangleMesh& mesh, const Grid& grid,
  const LocalThicknessOptions& options = {});

} // namespace medial
