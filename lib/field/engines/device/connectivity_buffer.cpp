#include "field/engines/device/connectivity_buffer.h"

namespace medial
{

ConnectivityBuffer::ConnectivityBuffer(const TriangleMesh& mesh,
  const MeshConnectivity& connectivity, Kernels& kernels)
  : faceCount_(static_cast<int>(mesh.triangles.size()))
  , edgeCount_(static_cast<int>(connectivity.edges.size()))
  , vertexCount_(static_cast<int>(mesh.points.size()))
  , incidenceCount_(static_cast<int>(connectivity.edgeTriangles.values.size()))
{
  std::int64_t offset = 0;
  const auto section = [&](const auto& values)
  {
    const auto bytes = static_cast<std::int64_t>(values.size() * sizeof(values[0]));
    if (buffer_)
    {
      kernels.upload(buffer_, offset, bytes, values.data());
    }
    offset += bytes;
  };
  const auto all = [&]
  {
    offset = 0;
    section(mesh.triangles);
    section(connectivity.triangleEdges);
    section(connectivity.edges);
    section(connectivity.edgeTriangles.offsets);
    section(connectivity.edgeTriangles.values);
    section(connectivity.pointEdges.offsets);
    section(connectivity.pointEdges.values);
  };
  all();
  obtainBuffer(buffer_, offset);
  all();
}

void ConnectivityBuffer::describe(const gl::ShaderProgram& program) const
{
  program.set("faceCount", faceCount_);
  program.set("edgeCount", edgeCount_);
  program.set("vertexCount", vertexCount_);
  program.set("incidenceCount", incidenceCount_);
}

} // namespace medial
