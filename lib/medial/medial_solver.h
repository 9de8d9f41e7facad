#pragma once

#include "medial/distance/distance_field.h"
#include "medial/medial/medial_axis.h"

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
class MedialSolver
{
public:
  /// @throws Error InvalidInput as analyseTopology().
  explicit MedialSolver(TriangleMesh mesh);
  ~MedialSolver();
  MedialSolver(MedialSolver&& other) noexcept;
  MedialSolver& operator=(MedialSolver&& other) noexcept;

  const TriangleMesh& mesh() const;
  const MeshTopology& topology() const;

  /// Moves the mesh.
  /// @param points as many as mesh().points, in the same order; world units.
  /// @throws Error InvalidInput when the number differs or a coordinate is not finite; the mesh is
  ///   then as it was.
  void setPoints(std::vector<Point3> points);

  /// As the functions computeDistanceField() and computeMedialAxis(), for the current positions.
  /// Fastest when grid and extent stay the same.
  RunStatistics computeField(const Grid& grid, const Extent& extent, const FieldArrays& arrays,
    const DistanceFieldOptions& options = {});
  RunStatistics computeField(const Grid& grid, const Extent& extent, FieldSink& sink,
    const DistanceFieldOptions& options = {});
  MedialAxis computeAxis(const Grid& grid, const MedialAxisOptions& options = {},
    const FieldArrays& arrays = {});

private:
  struct State;
  std::unique_ptr<State> state_;
};

} // namespace medial
