#pragma once

#include "medial/default_angle.h"
#include "medial/distance_field.h"
#include "medial/export.h"
#include "medial/medial_axis.h"
#include "medial/representation.h"
#include "medial/side.h"

#include <cstdint>

namespace medial
{

/// Whether the medial axis must have the topology of the solid.
enum class Topology
{
  Selected, ///< what the separation angle selects, in as many pieces as that is
  Preserve  ///< as many pieces, tunnels and cavities as the solid at the resolution of the grid
};

/// How a medial axis is computed.
struct MedialAxisOptions
{
  /// Least separation angle theta of the directions to the two closest points, in degrees, in
  /// (0, 180). Small values keep more of the axis and more noise. Grid edges are selected by the
  /// directions at their ends (Foskey et al. 2003); faces are these, while every point of a surface
  /// or point set has the angle itself.
  double angle = kDefaultAngle;
  /// Least MedialAxis::lambda, world units, >= 0: half the distance of the two closest points.
  /// Takes away what noise of that size makes, and what lies behind thinner walls.
  double lambda = 0.0;
  /// Least radius of the medial balls, world units, >= 0.
  double radius = 0.0;
  Side side = Side::Interior;                              ///< of the surface
  Representation representation = Representation::Surface; ///< what the axis is made of
  /// Most points of the axis, >= 0; 0 for no limit. Otherwise the axis is made compact, as by
  /// simplifyAxis(): fewer points describe the shape less closely. Not for Representation::Points.
  std::int64_t maxSpheres = 0;
  /// Preserve: whatever theta is, the axis has the components, the Euler characteristic and the
  /// genus of its solid, the closed voxels around the grid points of the side, those on the border
  /// of the grid left out. Voxels are taken away from the surface on by collapses only, which stop
  /// at selected sheets; where the sheets leave something open the axis goes on as a curve or as
  /// part of a sheet with smaller separation angles. Curves are kept where the radius grows by at
  /// most cos(theta / 2) per length over four voxels. Each side is thinned by itself; that of an
  /// unsigned field is the whole grid. Needs 10 bytes a grid point, and Representation::Surface or
  /// Faces. After Liu, Chambers, Letscher, Ju, "A simple and robust thinning algorithm on cell
  /// complexes", 2010, and Yan, Letscher, Ju, "Voxel Cores", 2018.
  Topology topology = Topology::Selected;
  DistanceFieldOptions field; ///< the distance field that the axis is taken from
};

/// Medial axis of a mesh, simplified by separation angle (Foskey, Lin, Manocha, 2003), from the
/// distance field on `grid`. Points of Representation::Points lie on the bisector of their two
/// sites, those of a surface where such bisectors meet (a quadratic error function over them),
/// those of faces at the corners of voxels. Sheets of a surface that end in a sharp convex edge
/// reach up to balls of a twentieth of a grid step, or the least lambda and radius (not where the
/// topology is preserved). Radii are exact at all of them; closestPointB may be 0.1 grid step
/// farther where facets approximate a round surface, 0.3 where a vertex of a surface stands off the
/// bisector, and a step at corners of faces. Surfaces and faces need a grid of at least two slices
/// along every axis.
///
/// @param arrays where to leave the distance field of the whole grid as well; all null for none.
/// @throws Error InvalidInput for an angle outside (0, 180), a negative lambda, radius or
///   maxSpheres, for maxSpheres or Topology::Preserve with Representation::Points, and as
///   computeDistanceField.
MEDIAL_EXPORT MedialAxis computeMedialAxis(const TriangleMesh& mesh,
  const MeshConnectivity& connectivity, const Grid& grid, const MedialAxisOptions& options = {},
  const FieldArrays& arrays = {});

/// The same, with the distance field delivered slab by slab, for grids that memory cannot hold.
/// Exceptions of the sink end the run and are passed on.
MEDIAL_EXPORT MedialAxis computeMedialAxis(const TriangleMesh& mesh,
  const MeshConnectivity& connectivity, const Grid& grid, const MedialAxisOptions& options,
  FieldSink& sink);

/// The same for a mesh whose connectivity the caller has no use for.
MEDIAL_EXPORT MedialAxis computeMedialAxis(const TriangleMesh& mesh, const Grid& grid,
  const MedialAxisOptions& options = {});

} // namespace medial
