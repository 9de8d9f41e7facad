#include "result.h"

namespace medial::app
{

MeshFigures figuresOf(const TriangleMesh& mesh, const MeshConnectivity& connectivity)
{
  return { mesh.triangles.size(), mesh.points.size(), connectivity.components,
    mesh.degenerateTriangles, connectivity.closed(), connectivity.manifold(),
    mesh.bounds().diagonal() };
}

} // namespace medial::app
