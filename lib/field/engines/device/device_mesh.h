#pragma once

#include "field/engines/device/connectivity_buffer.h"
#include "field/engines/device/kernels.h"
#include "medial/mesh_connectivity.h"
#include "medial/triangle_mesh.h"
#include "sites/local_coordinates.h"

#include <cstdint>
#include <vector>

namespace medial
{

/// A level of the tree over the groups of elements: where its discs are.
struct TreeLevel
{
  int first;
  int count;
};

/// A mesh on the device: its sites, its elements in groups of eight, and a tree of discs over them.
/// The connectivity is uploaded once; what depends on positions is made on the device. GPU thread
/// only, but for pack().
class DeviceMesh
{
public:
  /// Bytes of the largest buffer that a mesh takes, with those of its pseudonormals.
  static std::int64_t largestBuffer(const TriangleMesh& mesh, const MeshConnectivity& connectivity);
  /// Number of elements whose buffers a limit allows, whatever their connectivity.
  static int elementsWithin(std::int64_t limit);

  /// @throws Error GpuLimit or OutOfMemory.
  DeviceMesh(const TriangleMesh& mesh, const MeshConnectivity& connectivity, Kernels& kernels);

  /// Packs positions for the next move(). Needs no OpenGL: for the caller's thread, while no job of
  /// this mesh runs.
  /// @param mesh of the same connectivity.
  /// @param reach how far from the local origin grid points are, local units.
  void pack(const TriangleMesh& mesh, const LocalCoordinates& local, double reach);
  /// Takes over the positions that are packed.
  void move(Kernels& kernels);

  /// Sets the uniforms of mesh.glsl.
  void describe(const gl::ShaderProgram& kernel) const { connectivity_.describe(kernel); }

  const gl::Buffer& connectivity() const { return connectivity_.buffer(); }
  const gl::Buffer& points() const { return points_; }
  const gl::Buffer& faces() const { return faces_; }
  const gl::Buffer& order() const { return order_; }
  const gl::Buffer& elements() const { return elements_; }
  /// Number of slots in groups.
  int slotCount() const { return slotCount_; }
  /// Number of sites.
  int siteCount() const;
  const gl::Buffer& discs() const { return discs_; }
  /// The groups, then the levels above up to a single node.
  const std::vector<TreeLevel>& levels() const { return levels_; }
  /// Bound of the rounding of single precision near the mesh and the grid, local units.
  float slack() const { return slack_; }
  /// Bound of the difference of a coordinate from that of the host, local units.
  double positionError() const { return fixedPoint_ ? 0.51 * quantum_ : 0.0; }
  /// How far from the local origin points are, local units.
  double reach() const { return reach_; }

private:
  void allocate();
  void uploadPoints(Kernels& kernels);
  void buildSites(Kernels& kernels) const;
  void buildTree(Kernels& kernels) const;

  ConnectivityBuffer connectivity_;
  int slotCount_;
  std::vector<TreeLevel> levels_;
  float slack_ = 0.0f;
  double reach_ = 0.0;
  double flatHeight_ = 0.0;
  ///@{
  /// Positions: fixed-point numbers of a quantum from the lowest coordinates on, or halves of
  /// double-precision ones.
  std::vector<std::uint32_t> packed_;
  bool fixedPoint_ = false;
  glm::dvec3 low_{ 0.0 };
  double quantum_ = 1.0;
  ///@}
  gl::Buffer order_, positions_, points_, faces_, edges_, vertices_, elements_, discs_;
};

} // namespace medial
