#pragma once

#include "medial/compute_medial_axis.h"
#include "medial/distance_field.h"
#include "medial/export.h"
#include "medial/mesh_connectivity.h"
#include "medial/triangle_mesh.h"

#include <memory>
#include <vector>

namespace medial
{

/// Computes distance fields and medial axes of a mesh that deforms: the connectivity stays, the
/// positions change from frame to frame. Between frames the solver keeps what does not change:
/// connectivity, shader programs, textures, and buffers of the GPU, to which it uploads only
/// positions.
///
/// The results are those of computeDistanceField() and computeMedialAxis() on the same positions,
/// except that points which happen to become equal are not welded.
///
/// A solver must not be used by two threads at once.
class MEDIAL_EXPORT MedialSolver
{
public:
  /// Takes over the mesh in its first frame.
  /// @throws Error InvalidInput as analyseConnectivity().
  explicit MedialSolver(TriangleMesh mesh);
  ~MedialSolver();                                        ///< releases what it keeps
  MedialSolver(MedialSolver&& other) noexcept;            ///< leaves `other` without a mesh
  MedialSolver& operator=(MedialSolver&& other) noexcept; ///< leaves `other` without a mesh

  const TriangleMesh& mesh() const;             ///< at the current positions
  const MeshConnectivity& connectivity() const; ///< at the current positions as well

  /// Moves the points of the mesh.
  /// @param points as many as mesh().points, in the same order; world units.
  /// @throws Error InvalidInput if the number differs, or a coordinate is not finite or beyond
  ///   kMaxCoordinate; the mesh is then unchanged.
  void setPoints(std::vector<Point3> points);

  /// Computes the field at the current positions, as the function computeDistanceField() does. It
  /// is fastest if grid and extent stay the same.
  RunStatistics computeField(const Grid& grid, const Extent& extent, const FieldArrays& arrays,
    const DistanceFieldOptions& options = {});
  /// The same, delivered slab by slab.
  RunStatistics computeField(const Grid& grid, const Extent& extent, FieldSink& sink,
    const DistanceFieldOptions& options = {});
  /// Computes the axis at the current positions, as the function computeMedialAxis() does.
  MedialAxis computeAxis(const Grid& grid, const MedialAxisOptions& options = {},
    const FieldArrays& arrays = {});

private:
  struct State;
  std::unique_ptr<State> state_;
};

} // namespace medial
