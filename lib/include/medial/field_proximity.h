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
  /// Grid points along the longest side of the region, in [kMinResolution, kMaxDimension].
  int resolution = 64;
  Engine engine = Engine::Auto; ///< what computes the fields
  Execution execution;          ///< threads, progress and cancelling
};

/// The proximity of two meshes, A and B, by their distance fields.
struct FieldProximity
{
  /// The grid of the fields: over the common part of the meshes' boxes or, if they do not collide
  /// there, where the closest points must be. Of a fine grid only the part that can decide is
  /// computed, found from the fields at every eighth point; the result is that of the whole grid.
  Grid grid;
  /// Smallest sum of the two distances at a grid point outside both, world units: it exceeds the
  /// separation by at most a diagonal of the spacing. 0 if they collide; infinity if no grid point
  /// is outside both.
  double separation = 0.0;
  /// Whether a grid point is inside both: overlaps thinner than the spacing are missed, and so are
  /// surfaces without an inside.
  bool collide = false;
  /// The largest distance to one surface of a grid point inside it and within half a diagonal of
  /// the spacing of the other surface: off the penetration depth by at most that half. 0 if they do
  /// not collide.
  double depth = 0.0;
  Point3 deepestPoint{}; ///< the grid point where depth is
  /// The largest sum of both distances at a grid point inside both: a lower bound of the
  /// translational depth.
  double commonDepth = 0.0;
  double overlapVolume = 0.0; ///< of the cells of the grid points inside both, world units cubed
  double seconds = 0.0;       ///< wall-clock time
};

/// Computes proximity as the paper does (Sud, Govindaraju, Gayle, Manocha, I3D 2006, section 6):
/// from the distance fields of two meshes where these come close, frame after frame. It covers the
/// whole overlap at the resolution of the grid; ProximitySolver is exact, and faster.
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
