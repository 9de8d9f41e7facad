#include "sign/closed_surface.h"

namespace medial
{

TriangleChain ClosedSurface::lids() const
{
  const auto first = chain.triangles.begin() + static_cast<std::ptrdiff_t>(firstLid);
  return { chain.points, { first, chain.triangles.end() } };
}

TriangleChain chainOf(const TriangleMesh& mesh, const SurfaceOrientation& orientation,
  const LocalCoordinates& local)
{
  TriangleChain chain;
  chain.points.reserve(mesh.points.size());
  for (const Point3& point : mesh.points)
  {
    chain.points.push_back(local.toLocal(point));
  }
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
  {
    if (orientation.weights[t] != 0)
    {
      chain.triangles.push_back({ mesh.triangles[t], orientation.weights[t] });
    }
  }
  return chain;
}

ClosedSurface closeSurface(const TriangleMesh& mesh, const SurfaceOrientation& orientation,
  const LocalCoordinates& local)
{
  ClosedSurface surface;
  surface.chain = chainOf(mesh, orientation, local);
  TriangleChain& chain = surface.chain;
  surface.firstLid = chain.triangles.size();
  const std::vector<WeightedTriangle> lids = lidsOf(orientation.rim);
  chain.triangles.insert(chain.triangles.end(), lids.begin(), lids.end());
  surface.holes = countHoles(orientation.rim);
  return surface;
}

} // namespace medial
