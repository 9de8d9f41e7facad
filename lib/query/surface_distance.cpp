#include "query/surface_distance.h"

#include "medial/distance_field.h"
#include "sites/pseudonormals.h"

#include <limits>

namespace medial
{
namespace
{

/// The frame's unit: fine enough that no triangle counts as too thin to have a face.
GridFrame frameOf(const TriangleMesh& mesh)
{
  return GridFrame(makeGrid(mesh.bounds(), kMaxDimension));
}

/// All faces, and the edges and vertices that belong to none.
std::vector<int> itemsOf(const SiteSet& sites, const MeshConnectivity& connectivity)
{
  std::vector<int> items;
  for (int face = 0; face < sites.faceCount(); ++face)
  {
    items.push_back(face);
  }
  for (int edge = 0; edge < sites.edgeCount(); ++edge)
  {
    if (connectivity.edgeTriangles.size(edge) == 0)
    {
      items.push_back(sites.firstEdge() + edge);
    }
  }
  for (int vertex = 0; vertex < sites.vertexCount(); ++vertex)
  {
    if (connectivity.pointEdges.size(vertex) == 0)
    {
      items.push_back(sites.firstVertex() + vertex);
    }
  }
  return items;
}

std::vector<ItemBounds> boundsOf(const SiteSet& sites, const std::vector<int>& items)
{
  std::vector<ItemBounds> bounds;
  bounds.reserve(items.size());
  for (const int site : items)
  {
    ItemBounds box = ItemBounds::nothing();
    const auto add = [&](int point) { box.add(sites.points()[point], 0.0); };
    switch (sites.kind(site))
    {
      case SiteKind::Face:
        add(sites.faces()[site].x);
        add(sites.faces()[site].y);
        add(sites.faces()[site].z);
        break;
      case SiteKind::Edge:
        add(sites.edges()[site - sites.firstEdge()].x);
        add(sites.edges()[site - sites.firstEdge()].y);
        break;
      case SiteKind::Vertex:
        add(site - sites.firstVertex());
        break;
    }
    bounds.push_back(box);
  }
  return bounds;
}

std::vector<glm::vec4> normalsOf(const SiteSet& sites, const MeshConnectivity& connectivity)
{
  if (resolveSignMethod(SignMethod::Auto, connectivity) == SignMethod::None)
  {
    return {};
  }
  return pseudonormals(sites, connectivity.signedVolume < 0.0);
}

} // namespace

SurfaceDistance::SurfaceDistance(const TriangleMesh& mesh, const MeshConnectivity& connectivity)
  : frame_(frameOf(mesh))
  , sites_(mesh, connectivity, frame_)
  , normals_(normalsOf(sites_, connectivity))
  , items_(itemsOf(sites_, connectivity))
  , tree_(boundsOf(sites_, items_))
{
}

double SurfaceDistance::signedDistance(const glm::dvec3& world) const
{
  const glm::dvec3 x = frame_.toFrame({ world.x, world.y, world.z });
  SitePoint closest;
  double distance = std::numeric_limits<double>::infinity();
  tree_.search(x, distance,
    [&](std::uint32_t item)
    {
      const SitePoint candidate = closestPoint(sites_, items_[item], x);
      const double found = glm::distance(candidate.point, x);
      if (found < distance)
      {
        distance = found;
        closest = candidate;
      }
    });
  const bool inside =
    this->knowsInside() && glm::dot(glm::dvec3(normals_[closest.site]), x - closest.point) < 0.0;
  return (inside ? -distance : distance) * frame_.unit;
}

} // namespace medial
