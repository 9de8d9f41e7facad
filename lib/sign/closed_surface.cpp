#include "sign/closed_surface.h"

#include <cstdlib>

namespace medial
{

double countedArea(const TriangleChain& chain, const WeightedTriangle& triangle)
{
  const auto [a, b, c] = chain.cornersOf(triangle);
  return std::abs(triangle.weight) * glm::length(glm::cross(b - a, c - a));
}

TriangleChain ClosedSurface::lids() const
{
  const auto first = chain.triangles.begin() + static_cast<std::ptrdiff_t>(firstLid);
  return { chain.points, { first, chain.triangles.end() } };
}

double ClosedSurface::lidShare() const
{
  double all = 0.0;
  double lids = 0.0;
  for (std::size_t i = 0; i < chain.triangles.size(); ++i)
  {
    const double area = countedArea(chain, chain.triangles[i]);
    all += area;
    lids += i < firstLid ? 0.0 : area;
  }
  return all > 0.0 ? lids / all : 0.0;
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
