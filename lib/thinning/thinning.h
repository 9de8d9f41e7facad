#pragma once

#include "base/checkpoint.h"
#include "thinning/bucket_queue.h"
#include "thinning/cubical_complex.h"
#include "thinning/curve_chains.h"

#include <cstddef>
#include <functional>
#include <queue>
#include <tuple>
#include <vector>

namespace medial
{

/// Thins a cubical complex by collapses until no voxel is left. A collapse removes a cell that is
/// not a face of another cell, together with a face that belongs to no other cell. Since it is a
/// deformation retraction, components, tunnels and cavities stay as they are.
///
/// A fire starts at the surface. It takes voxels in the order of their distances, and faces and
/// edges as soon as they have a free edge or vertex; along curves (CurveProbe) it takes edges at
/// unit speed. It stops at anchored faces and at curves that are long and blunt enough
/// (CurveChains). Where anchored faces enclose voxels, the fire enters through the face with the
/// smallest angle. The result does not depend on the number of threads: the fire runs on one.
class Thinning
{
public:
  using EdgeTest = std::function<bool(CubeCell edge)>;
  using DepthAt = std::function<float(std::size_t voxel)>;
  /// @param complex the solid, which becomes what is left of it.
  /// @param depthAt tells the depths of voxels and those next to them, as DepthField::at().
  /// @param separates tells which edges a curve may follow, as CurveProbe does.
  /// @param step frame distance of neighbouring grid points.
  /// @param checkpoint called now and then; must outlive this object.
  Thinning(CubicalComplex& complex, DepthAt depthAt, EdgeTest separates, const glm::dvec3& step,
    const CurveLimits& limits, const Checkpoint& checkpoint);

  using FaceAngle = std::function<float(CubeCell face)>;
  /// Makes faces stay.
  /// @param angleOf tells their angles: the face with the smallest gives way first if one must.
  void anchor(const std::vector<CubeCell>& faces, FaceAngle angleOf);

  /// Burns all cells that can be reached from outside.
  void burn();
  /// Burns faces that were anchored, and all cells that can be reached then.
  void release(const std::vector<CubeCell>& faces);

private:
  struct Event
  {
    CubeCell cell;
    int chain;
  };
  using Gate = std::tuple<float, CubeCell, CubeCell>; ///< angle, anchored face, voxel behind it

  void raise(CubeCell cell, int chain = CurveChains::kNone);
  void raiseEdge(CubeCell edge, int chain);
  void drain();
  void burnVoxel(CubeCell voxel);
  void burnFace(CubeCell face);
  void burnEdge(CubeCell edge, int chain);
  bool openGate();
  /// Removes both cells; a fire along curves goes on with `edgeChain`.
  void collapse(CubeCell cell, CubeCell freeFace, int edgeChain = CurveChains::kNone);
  bool hasFreeFace(CubeCell cell) const;
  CubeCell freeFace(CubeCell cell, bool anchoredToo = true) const;
  glm::vec3 edgePosition(CubeCell edge) const;
  float depthAround(CubeCell cell) const;

  CubicalComplex& complex_;
  /// Faces, and edges of curves that are kept; and voxels that are in the queue.
  CubicalComplex anchors_;
  DepthAt depthAt_;
  EdgeTest separates_;
  glm::dvec3 step_;
  CurveChains chains_;
  const Checkpoint& checkpoint_;
  FaceAngle angleOf_;
  BucketQueue<Event> queue_;
  std::priority_queue<Gate, std::vector<Gate>, std::greater<>> gates_;
};

} // namespace medial
