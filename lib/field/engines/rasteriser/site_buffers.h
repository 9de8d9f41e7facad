#pragma once

#include "field/engines/device/connectivity_buffer.h"
#include "sites/site_set.h"

#include <glm/glm.hpp>

#include <vector>

namespace medial
{

/// The sites of a mesh in device memory, as the shaders of the engine `device` read them. GPU
/// thread only.
class SiteBuffers
{
public:
  /// @throws Error GpuLimit or OutOfMemory.
  SiteBuffers(const TriangleMesh& mesh, const MeshConnectivity& connectivity, Kernels& kernels);

  /// Takes over positions.
  /// @param sites of the mesh.
  /// @param normals pseudonormals() of all sites, reversed if the surface faces inwards; empty if
  /// they do not give the sign.
  /// @throws Error GpuLimit or OutOfMemory.
  void move(const SiteSet& sites, const std::vector<glm::vec4>& normals, Kernels& kernels);

  /// Sets the uniforms of mesh.glsl.
  void describe(const gl::ShaderProgram& program) const { connectivity_.describe(program); }

  const gl::Buffer& connectivity() const { return connectivity_.buffer(); }
  const gl::Buffer& points() const { return points_; }
  const gl::Buffer& faces() const { return faces_; }     ///< as faces.glsl reads them
  const gl::Buffer& normals() const { return normals_; } ///< has no values if there are none

private:
  ConnectivityBuffer connectivity_;
  gl::Buffer points_, faces_, normals_;
};

} // namespace medial
