#pragma once

#include "medial/default_angle.h"
#include "medial/distance_field.h"
#include "medial/export.h"
#include "medial/medial_axis.h"
#include "medial/mesh_connectivity.h"
#include "medial/representation.h"
#include "medial/side.h"
#include "medial/triangle_mesh.h"

#include <cstdint>

namespace medial
{

/// Which topology the medial axis has.
enum class Topology
{
  Selected, ///< that of the parts that the separation angle selects, in any number of pieces
  Preserve  ///< the components, tunnels and cavities of the solid at the resolution of the grid
};

/// How a medial axis is computed.
struct MedialAxisOptions
{
  /// Minimum separation angle theta between the directions to the two closest points, in degrees,
  /// in (0, 180). Smaller values keep more of the axis and more noise. With Representation::Faces,
  /// grid edges are selected by the directions at their ends (Foskey et al. 2003). Every point of a
  /// point set has at least this angle itself, and so has every point of a surface between flat
  /// walls. Where facets approximate a round wall, a sheet is selected, and ends, by the angle of
  /// its neighbourhood; single points of it may have less, down to 0.8 theta.
  double angle = kDefaultAngle;
  /// Minimum MedialAxis::lambda, world units, >= 0: half the distance between the closest pair.
  /// Removes what noise of this size causes. Walls thinner than twice this value lose their axis.
  double lambda = 0.0;
  /// Minimum radius of the medial balls, world units, >= 0.
  double radius = 0.0;
  Side side = Side::Interior;                              ///< side of the surface
  Representation representation = Representation::Surface; ///< what the axis is made of
  /// Maximum number of points of the axis, >= 0; 0 for no limit. With a limit the axis is made
  /// compact, as by simplifyAxis(): fewer points describe the shape less closely. Not for
  /// Representation::Points.
  std::int64_t maxSpheres = 0;
  /// With Topology::Preserve the axis has the components, the Euler characteristic and the genus of
  /// its solid for every theta. The solid consists of the closed voxels around the grid points of
  /// the side, without those on the border of the grid. Thinning removes voxels from the surface
  /// inwards, by collapses only, and stops at selected sheets. Where the sheets leave gaps, the
  /// axis continues as a curve or as part of a sheet with smaller separation angles. A curve is
  /// kept where the radius grows by at most cos(theta / 2) per unit of length over four voxels.
  /// Each side is thinned on its own; for an unsigned field the whole grid is thinned. Needs 14
  /// bytes per grid point, and Representation::Surface or Faces. After Liu, Chambers, Letscher, Ju,
  /// "A simple and robust thinning algorithm on cell complexes", 2010, and Yan, Letscher, Ju,
  /// "Voxel Cores", 2018.
  Topology topology = Topology::Selected;
  DistanceFieldOptions field; ///< how the distance field of the axis is computed
};

/// Computes the medial axis of a mesh from the distance field on `grid`, simplified by separation
/// angle (Foskey, Lin, Manocha, 2003).
///
/// Points of Representation::Points lie on the bisector of their two sites, those of a surface
/// where such bisectors meet (by a quadratic error function), and those of faces at the corners of
/// voxels. Sheets of a surface end in smooth lines where the angle, lambda or the radius reaches
/// its limit, and those that end in a sharp convex edge extend to balls with a radius of a
/// twentieth of a grid step, or to the minimum lambda and radius (neither if the topology is
/// preserved). All radii are exact. closestPointB can be farther away than the radius: by 0.1 grid
/// step where facets approximate a round surface, by 0.3 where a vertex of a surface lies off the
/// bisector or on a border, and by a step at corners of faces. Surfaces and faces need a grid of at
/// least two slices along every axis.
///
/// @param arrays receive the distance field of the whole grid as well; all null if you do not need
///   it.
/// @throws Error InvalidInput for an angle outside (0, 180), a negative lambda, radius or
///   maxSpheres, for maxSpheres or Topology::Preserve with Representation::Points, and as
///   computeDistanceField.
MEDIAL_EXPORT MedialAxis computeMedialAxis(const TriangleMesh& mesh,
  const MeshConnectivity& connectivity, const Grid& grid, const MedialAxisOptions& options = {},
  const FieldArrays& arrays = {});

/// The same, but delivers the distance field slab by slab, for grids that do not fit into memory.
/// Exceptions of the sink end the run and reach the caller.
MEDIAL_EXPORT MedialAxis computeMedialAxis(const TriangleMesh& mesh,
  const MeshConnectivity& connectivity, const Grid& grid, const MedialAxisOptions& options,
  FieldSink& sink);

/// The same for callers that do not need the connectivity of the mesh.
MEDIAL_EXPORT MedialAxis computeMedialAxis(const TriangleMesh& mesh, const Grid& grid,
  const MedialAxisOptions& options = {});

} // namespace medial
