#include "sign/inside_query.h"

#include "sign/closed_surface.h"
#include "sign/surface_orientation.h"

#include <utility>

namespace medial
{

InsideQuery::InsideQuery(const TriangleMesh& mesh, const MeshConnectivity& connectivity,
  const LocalCoordinates& local)
{
  const SurfaceOrientation orientation = orientSurface(mesh, connectivity);
  TriangleChain surface = chainOf(mesh, orientation, local);
  if (orientation.rim.empty() && !surface.triangles.empty())
  {
    closed_ = std::make_unique<const LineWinding>(std::move(surface));
  }
  else
  {
    open_ = std::make_unique<const WindingNumber>(surface);
  }
}

} // namespace medial
