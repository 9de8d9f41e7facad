#pragma once

#include "field/engines/device/kernels.h"
#include "medial/mesh_connectivity.h"
#include "medial/triangle_mesh.h"

namespace medial
{

/// Who shares points with whom, in device memory: the connectivity of mesh.glsl. GPU thread only.
class ConnectivityBuffer
{
public:
  /// @throws Error GpuLimit or OutOfMemory.
  ConnectivityBuffer(const TriangleMesh& mesh, const MeshConnectivity& connectivity,
    Kernels& kernels);

  /// Sets the uniforms of mesh.glsl.
  void describe(const gl::ShaderProgram& program) const;

  const gl::Buffer& buffer() const { return buffer_; }
  int faceCount() const { return faceCount_; }
  int edgeCount() const { return edgeCount_; }
  int vertexCount() const { return vertexCount_; }

private:
  int faceCount_, edgeCount_, vertexCount_, incidenceCount_;
  gl::Buffer buffer_;
};

} // namespace medial
