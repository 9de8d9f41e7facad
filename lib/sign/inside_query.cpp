#include "sign/inside_query.h"

#include "sign/closed_surface.h"
#include "sign/surface_orientation.h"

#include <utility>

namespace medial
{

InsideQuery::InsideQuery(const TriangleMesh& mesh, const MeshConnectivity& connectivity,
  const LocalCoordinates& local)
  : InsideQuery(closeSurface(mesh, orientSurface(mesh, connectivity), local))
{
}

InsideQuery::InsideQuery(ClosedSurface surface)
  : hasTriangles_(!surface.chain.triangles.empty())
{
  if (surface.holes > 0)
  {
    lids_ = std::make_unique<const WindingNumber>(surface.lids());
  }
  surface_ = std::make_unique<const LineWinding>(std::move(surface.chain));
}

bool InsideQuery::contains(const glm::dvec3& x) const
{
  return isInside([this](const glm::dvec3& at) { return surface_->at(at); }, lids_.get(), x);
}

} // namespace medial
