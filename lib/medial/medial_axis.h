#pragma once

#include "medial/distance/distance_field.h"
#include "medial/medial/medial_curves.h"
#include "medial/medial/topology/cell_topology.h"

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

namespace medial
{

/// Which side of the surface the medial axis is wanted for.
enum class Side
{
  Interior, ///< where the signed distance is negative
  Exterior, ///< where it is positive
  Both      ///< everywhere; the only choice for an unsigned field
};

/// What the medial axis is made of.
enum class Representation
{
  Surface, ///< dual mesh: a vertex per grid cell, a face per crossed grid edge
  Faces,   ///< the voxel faces between the two ends of each crossed grid edge (Foskey et al.)
  Points   ///< one point per crossed grid edge, on the bisector of the two closest sites
};

/// Whether the medial axis must have the topology of the solid.
enum class Topology
{
  Selected, ///< what the separation angle selects, in as many pieces as that is
  Preserve  ///< as many pieces, tunnels and cavities as the solid at the resolution of the grid
};

/// Default separation angle theta, in degrees.
constexpr double kDefaultAngle = 60.0;

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

/// What simplifyAxis() did; all 0 where it was not called.
struct SimplificationStatistics
{
  std::int64_t inputPoints = 0;     ///< of the full axis
  std::int64_t inputComponents = 0; ///< of the full axis
  std::int64_t components = 0;      ///< of the result
  std::int64_t joined = 0;  ///< lines that were added between components whose balls overlap
  std::int64_t forced = 0;  ///< balls merged though that closed a loop or a hollow of the shape
  std::int64_t dropped = 0; ///< components left out
  double seconds = 0.0;     ///< wall-clock
};

/// A medial axis as points with attributes and cells over them.
struct MedialAxis
{
  std::vector<Point3> points;         ///< centres of medial balls, world coordinates
  std::vector<float> radius;          ///< distance to the surface, world units
  std::vector<float> separationAngle; ///< degrees, [0, 180]
  std::vector<float> lambda;          ///< radius * sin(separationAngle / 2), world units
  std::vector<std::array<float, 3>> closestPointA; ///< world coordinates
  std::vector<std::array<float, 3>> closestPointB; ///< world coordinates
  std::vector<AxisFeature> feature;                ///< what each point lies on

  /// Cells by number of distinct corners; a cell never repeats a point and never has zero area.
  /// Where the axis is thinner than a sheet at this resolution it comes as lines and vertices.
  std::vector<std::array<std::int64_t, 4>> quads;
  std::vector<std::array<std::int64_t, 3>> triangles; ///< ids of points
  std::vector<std::array<std::int64_t, 2>> lines;     ///< ids of points
  std::vector<std::int64_t> vertices;                 ///< ids of points

  SignMethod sign = SignMethod::None; ///< the method used, never Auto
  Side side = Side::Both;             ///< the side delivered: Both where the field is unsigned
  /// Of the solid, where the topology is preserved; topologyOf(axis) is the same then, unless
  /// maxSpheres is too small for it.
  std::optional<CellTopology> solid;
  RunStatistics statistics;                ///< what computing it took
  SimplificationStatistics simplification; ///< what simplifyAxis() did

  /// Number of cells of all kinds.
  std::int64_t cellCount() const
  {
    return static_cast<std::int64_t>(
      quads.size() + triangles.size() + lines.size() + vertices.size());
  }
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
MedialAxis computeMedialAxis(const TriangleMesh& mesh, const MeshTopology& topology,
  const Grid& grid, const MedialAxisOptions& options = {}, const FieldArrays& arrays = {});

/// The same, with the distance field delivered slab by slab, for grids that memory cannot hold.
/// Exceptions of the sink end the run and are passed on.
MedialAxis computeMedialAxis(const TriangleMesh& mesh, const MeshTopology& topology,
  const Grid& grid, const MedialAxisOptions& options, FieldSink& sink);

/// The same for a mesh whose topology the caller has no use for.
MedialAxis computeMedialAxis(const TriangleMesh& mesh, const Grid& grid,
  const MedialAxisOptions& options = {});

} // namespace medial
