#include "sign/closed_surface.h"

namespace medial
{

TriangleChain ClosedSurface::lid(std::size_t index) const
{
  TriangleChain result;
  for (std::size_t t = lidOffsets[index]; t < lidOffsets[index + 1]; ++t)
  {
    const auto first = static_cast<int>(result.points.size());
    for (const glm::dvec3& corner : chain.cornersOf(chain.triangles[t]))
    {
      result.points.push_back(corner);
    }
    result.triangles.push_back({ { first, first + 1, first + 2 }, chain.triangles[t].weight });
  }
  return result;
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
  ClosedSurface surface{ chainOf(mesh, orientation, local), {} };
  TriangleChain& chain = surface.chain;
  surface.lidOffsets.push_back(chain.triangles.size());
  for (const Lid& lid : lidsOf(orientation.rim, chain.points))
  {
    const auto tip = static_cast<int>(chain.points.size());
    chain.points.push_back(lid.tip);
    for (const RimEdge& edge : lid.rim)
    {
      chain.triangles.push_back({ { edge.to, edge.from, tip }, edge.weight });
    }
    surface.lidOffsets.push_back(chain.triangles.size());
  }
  return surface;
}

} // namespace medial
