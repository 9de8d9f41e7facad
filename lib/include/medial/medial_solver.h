#pragma once

#include "medial/compute_medial_axis.h"
#include "medial/distance_field.h"
#include "medial/export.h"

#include <memory>
#include <vector>

namespace medial
{

/// Distance fields and medial axes of a mesh that deforms: the same connectivity, other positions
/// every frame. Between frames it keeps what does not change (connectivity, shader programs,
/// textures and buffers of the GPU, to which only positions are uploaded) and the closest sites of
/// the last frame, whose distances bound those of the next.
///
/// The results are those of computeDistanceField() and computeMedialAxis() on the same positions,
/// but that points which happen to become equal are not joined.
///
/// Not to be used from two threads at once.
class MEDIAL_EXPORT MedialSolver
{
public:
  /// Takes over the mesh in its first frame.
  /// @throws Error InvalidInput as analyseConnectivity().
  explicit MedialSolver(TriangleMesh mesh);
  ~MedialSolver();                                        ///< gives back what it keeps
  MedialSolver(MedialSolver&& other) noexcept;            ///< leaves `other` without a mesh
  MedialSolver& operator=(MedialSolver&& other) noexcept; ///< leaves `other` without a mesh

  const TriangleMesh& mesh() const;             ///< at the current positions
  const MeshConnectivity& connectivity() const; ///< of the same

  /// Moves the mesh.
  /// @param points as many as mesh().points, in the same order; world units.
  /// @throws Error InvalidInput when the number differs, or a coordinate is not finite or beyond
  ///   kMaxCoordinate; the mesh is then as it was.
  void setPoints(std::vector<Point3> points);

  /// As the function computeDistanceField(), for the current positions. Fastest when grid and
  /// extent stay the same.
  RunStatistics computeField(const Grid& grid, const Extent& extent, const FieldArrays& arrays,
    const DistanceFieldOptions& options = {});
  /// The same, delivered slab by slab.
  RunStatistics computeField(const Grid& grid, const Extent& extent, FieldSink& sink,
    const DistanceFieldOptions& options = {});
  /// As the function computeMedialAxis(), for the current positions.
  MedialAxis computeAxis(const Grid& grid, const MedialAxisOptions& options = {},
    const FieldArrays& arrays = {});

private:
  struct State;
  std::unique_ptr<State> state_;
};

} // namespace medial
