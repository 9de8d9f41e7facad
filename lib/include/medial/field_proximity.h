#pragma once

#include "medial/engine.h"
#include "medial/execution.h"
#include "medial/export.h"
#include "medial/grid.h"
#include "medial/triangle_mesh.h"

#include <cstdint>
#include <memory>
#include <vector>

namespace medial
{

/// How proximity is computed from distance fields.
struct FieldProximityOptions
{
  /// Grid points along the longest side of the region, in [2, kMaxDimension].
  int resolution = 64;
  Engine engine = Engine::Auto; ///< what computes the fields
  Execution execution;          ///< threads, progress and cancelling
};

/// How two meshes, A and B, lie to each other, as their distance fields tell.
struct FieldProximity
{
  /// The grid of the fields: over the common part of the meshes' boxes or, if they do not collide
  /// there, where the closest points must be. Of fine grids only that part is computed that can
  /// decide, which the fields at every eighth point tell; the result is that of the whole.
  Grid grid;
  /// Least sum of the two distances at a grid point outside of both, world units: by a diagonal of
  /// the spacing at most above the separation. 0 if they collide; infinity if no grid point is
  /// outside of both.
  double separation = 0.0;
  /// Whether a grid point is inside both: overlaps that are thinner than the spacing are missed,
  /// and so are surfaces without an inside.
  bool collide = false;
  /// The largest distance to one surface, inside, of a grid point within half a diagonal of the
  /// spacing of the other: by this much off the penetration depth. 0 if they do not collide.
  double depth = 0.0;
  Point3 deepestPoint{}; ///< the grid point where depth is
  /// The largest sum of both distances at a grid point inside both: a lower bound of the
  /// translational depth.
  double commonDepth = 0.0;
  double overlapVolume = 0.0; ///< of the cells of the grid points inside both, world units cubed
  double seconds = 0.0;       ///< wall-clock time
};

/// Computes proximity in the way of the paper (Sud, Govindaraju, Gayle, Manocha, I3D 2006, section
/// 6): the distance fields of two meshes where these come close, frame after frame. It tells of the
/// whole overlap, to the resolution of the grid; ProximitySolver is exact, and faster.
///
/// A solver must not be used by two threads at once.
class MEDIAL_EXPORT FieldProximitySolver
{
public:
  /// Takes over two meshes in their first frame.
  /// @throws Error InvalidInput for an empty mesh, or as analyseConnectivity().
  FieldProximitySolver(TriangleMesh a, TriangleMesh b);
  ~FieldProximitySolver(); ///< releases what it keeps
  FieldProximitySolver(
    FieldProximitySolver&& other) noexcept; ///< `other` may then only be destroyed or assigned to
  FieldProximitySolver& operator=(
    FieldProximitySolver&& other) noexcept; ///< `other` may then only be destroyed or assigned to

  /// Moves the points of a mesh.
  /// @param mesh 0 for A, 1 for B.
  /// @param points as many as the mesh has, in the same order; world units.
  /// @throws Error InvalidInput as ProximitySolver::setPoints().
  void setPoints(int mesh, std::vector<Point3> points);

  /// Computes the fields at the current positions.
  /// @throws Error InvalidInput for a resolution outside its range, and as computeDistanceField().
  FieldProximity compute(const FieldProximityOptions& options = {});

private:
  struct State;
  std::unique_ptr<State> state_;
};

} // namespace medial
