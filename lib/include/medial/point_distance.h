#pragma once

#include "medial/closest_feature.h"
#include "medial/execution.h"
#include "medial/export.h"
#include "medial/grid.h"
#include "medial/mesh_connectivity.h"
#include "medial/sign_method.h"
#include "medial/triangle_mesh.h"

#include <cstdint>
#include <memory>
#include <vector>

namespace medial
{

/// Where the surface is, seen from each of many points. Every array has one element per point, in
/// the order of the points.
struct PointDistances
{
  /// To the closest point of the surface, world units; negative inside unless unsigned.
  std::vector<double> distance;
  std::vector<Point3> closestPoint;      ///< of the surface, world units
  std::vector<std::int64_t> closestCell; ///< id of an input cell that contains the closest point
  std::vector<Feature> closestFeature;   ///< what the closest point lies on
  /// Unit vector from the point to its closest point; zero where the point is on the surface.
  std::vector<Point3> direction;
};

/// A summary of many distances. Without points all figures are NaN.
struct DistanceSummary
{
  double min = 0.0;  ///< smallest distance, with its sign, world units
  double max = 0.0;  ///< largest distance, with its sign, world units
  double mean = 0.0; ///< mean of the magnitudes, world units
  double rms = 0.0;  ///< root of the mean square, world units
  /// Magnitude that no more than half of the points exceed, world units.
  double median = 0.0;
  /// Magnitude that no more than 5 % of the points exceed, world units.
  double percentile95 = 0.0;
};

/// Sums distances up, in the order of the points.
MEDIAL_EXPORT DistanceSummary summarise(const PointDistances& distances);

/// The point of a surface that is farthest from a mesh.
struct FarthestPoint
{
  Point3 point{};        ///< on the surface, world units
  double distance = 0.0; ///< of this point from the mesh, world units, >= 0
  double bound = 0.0;    ///< no point of the surface is farther than this
};

/// Finds the distances of any points from a mesh, exact in double precision, without a grid. The
/// mesh may have any topology, holes and degenerate triangles.
///
/// Triangles whose height is below 1.2e-8 times the diagonal of the mesh count only as their edges,
/// which moves closest points by at most half of that height.
class MEDIAL_EXPORT PointDistance
{
public:
  /// Prepares a mesh.
  /// @param mesh taken over.
  /// @param sign how to tell inside from outside, by the same rules as for a distance field.
  /// @throws Error InvalidInput for a mesh without cells, and for a sign method that the mesh does
  ///   not allow; OutOfMemory; Cancelled.
  explicit PointDistance(TriangleMesh mesh, SignMethod sign = SignMethod::Auto,
    const Execution& execution = {});
  ~PointDistance(); ///< releases what it keeps
  PointDistance(
    PointDistance&& other) noexcept; ///< `other` may then only be destroyed or assigned to
  PointDistance& operator=(
    PointDistance&& other) noexcept; ///< `other` may then only be destroyed or assigned to

  const TriangleMesh& mesh() const;             ///< the mesh
  const MeshConnectivity& connectivity() const; ///< of the mesh
  const SignReport& sign() const;               ///< how inside is told from outside, and why

  /// Computes the distances of points. Several threads may call it at once. The result does not
  /// depend on the number of threads, nor on which points are asked for together.
  /// @param points world units.
  /// @throws Error InvalidInput for a coordinate that is not finite or beyond kMaxCoordinate,
  ///   naming the point; OutOfMemory; Cancelled.
  PointDistances compute(const std::vector<Point3>& points, const Execution& execution = {}) const;

  /// Finds the point of a surface that is farthest from the mesh, wherever it is on a triangle or
  /// segment: the one-sided Hausdorff distance, by branch and bound. The larger of both directions
  /// is the Hausdorff distance of two meshes.
  /// @param surface its cells count, not only its points.
  /// @param tolerance in (0, 1): the search ends once FarthestPoint::bound is above the distance by
  ///   at most this fraction, or by 1e-6 of the diagonal of the surface if that is more; or after a
  ///   million steps, which takes seconds.
  /// @throws Error InvalidInput for a tolerance outside its range, an empty surface, and a
  ///   coordinate that is not finite; OutOfMemory; Cancelled.
  FarthestPoint farthest(const TriangleMesh& surface, double tolerance = 1e-3,
    const Execution& execution = {}) const;

private:
  struct State;
  std::unique_ptr<const State> state_;
};

} // namespace medial
