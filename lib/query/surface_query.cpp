#include "query/surface_query.h"

#include "sites/pseudonormals.h"

#include <algorithm>

namespace medial
{
namespace
{

/// Returns how far from the local origin points within bounds can be, local units.
double farthestOf(const LocalCoordinates& local, const Bounds& bounds)
{
  return std::max(glm::length(local.toLocal(bounds.min)), glm::length(local.toLocal(bounds.max)));
}

} // namespace

SurfaceQuery::SurfaceQuery(const TriangleMesh& mesh, const MeshConnectivity& connectivity,
  double margin)
  : SurfaceQuery(mesh, connectivity, margin,
      turned(mesh, connectivity, orientSurface(mesh, connectivity)))
{
}

SurfaceQuery::SurfaceQuery(const TriangleMesh& mesh, const MeshConnectivity& connectivity,
  double margin, const std::optional<OrientedMesh>& turnedMesh)
  : SurfaceQuery(LocalCoordinates::around(mesh.bounds(), margin),
      turnedMesh ? turnedMesh->mesh : mesh, turnedMesh ? turnedMesh->connectivity : connectivity)
{
}

SurfaceQuery::SurfaceQuery(const LocalCoordinates& local, const TriangleMesh& mesh,
  const MeshConnectivity& connectivity)
  : local_(local)
  , sites_(mesh, connectivity, local)
  , normals_(pseudonormals(sites_, false))
  , tree_(sites_, connectivity, roundingNear(0.0, sites_))
  , query_(tree_)
{
}

SurfaceQuery::SurfaceQuery(const LocalCoordinates& local, const TriangleMesh& mesh,
  const MeshConnectivity& connectivity, const Bounds& bounds, const std::vector<int>& elements)
  : local_(local)
  , sites_(mesh, connectivity, local)
  , normals_(pseudonormals(sites_, false))
  , tree_(sites_, connectivity, roundingNear(0.0, farthestOf(local, bounds)), elements)
  , query_(tree_)
{
}

double SurfaceQuery::distance(const Point3& world) const
{
  const glm::dvec3 x = local_.toLocal(world);
  const SitePoint found = this->closest(x);
  return found.site < 0 ? std::numeric_limits<double>::infinity()
                        : glm::distance(found.point, x) * local_.unit;
}

} // namespace medial
