#include "sign/inside_query.h"

#include "sign/closed_surface.h"
#include "sign/surface_orientation.h"

namespace medial
{

InsideQuery::InsideQuery(const TriangleMesh& mesh, const MeshConnectivity& connectivity,
  const LocalCoordinates& local)
  : InsideQuery(mesh, orientSurface(mesh, connectivity), local)
{
}

InsideQuery::InsideQuery(const TriangleMesh& mesh, const SurfaceOrientation& orientation,
  const LocalCoordinates& local)
  : winding_(chainOf(mesh, orientation, local))
  , closed_(orientation.rim.empty() && !mesh.triangles.empty())
{
}

} // namespace medial
