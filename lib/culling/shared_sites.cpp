#include "culling/shared_sites.h"

#include "culling/site_group.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <numeric>

namespace medial
{
namespace
{

/// Whether a face has the ends of one of its edges in their order.
bool runsAlong(const SiteSet& sites, int face, int edge)
{
  for (int i = 0; i < 3; ++i)
  {
    if (sites.faceEdges()[face][i] == edge)
    {
      return sites.faces()[face][i] == sites.edges()[edge][0];
    }
  }
  return false;
}

} // namespace

SharedSites::SharedSites(const SiteSet& sites, const MeshConnectivity& connectivity)
  : edgeOwners(sites.edgeCount())
  , vertexOwners(sites.vertexCount())
  , edgeFaces(sites.edgeCount(), glm::ivec2(kNone))
  , open(sites.vertexCount(), 0)
  , degenerate(sites.vertexCount(), 0)
  , pointEdges(connectivity.pointEdges)
{
  std::vector<char> closed(sites.edgeCount());
  std::vector<char> allActive(sites.edgeCount());
  tbb::parallel_for(0, sites.edgeCount(),
    [&](int edge)
    {
      int owner = sites.firstEdge() + edge;
      int active = 0;
      allActive[edge] = sites.active(owner) ? 1 : 0;
      int direction = 0; // how many more faces run along the edge than against it
      for (const int* face = connectivity.edgeTriangles.begin(edge);
           face != connectivity.edgeTriangles.end(edge); ++face)
      {
        owner = std::min(owner, *face);
        if (!sites.active(*face))
        {
          allActive[edge] = 0;
          continue;
        }
        if (active < 2)
        {
          edgeFaces[edge][active] = *face;
        }
        ++active;
        direction += runsAlong(sites, *face, edge) ? 1 : -1;
      }
      edgeOwners[edge] = owner;
      closed[edge] = active == 2 && direction == 0 ? 1 : 0;
    });
  tbb::parallel_for(0, sites.vertexCount(),
    [&](int vertex)
    {
      int owner = sites.firstVertex() + vertex;
      for (const int* edge = pointEdges.begin(vertex); edge != pointEdges.end(vertex); ++edge)
      {
        owner = std::min(owner, edgeOwners[*edge]);
        open[vertex] |= closed[*edge] == 0 ? 1 : 0;
        degenerate[vertex] |= allActive[*edge] == 0 ? 1 : 0;
      }
      vertexOwners[vertex] = owner;
    });
}

double SharedSites::minCosine(const SiteSet& sites, const SiteGroup& group,
  const glm::dvec3& axis) const
{
  std::array<int, 3 * SiteGroup::kSize> vertices;
  auto end = vertices.begin();
  for (const int element : group.elements)
  {
    if (sites.kind(element) != SiteKind::Face || !sites.active(element))
    {
      return -1.0;
    }
    for (int i = 0; i < 3; ++i)
    {
      *end++ = sites.faces()[element][i];
    }
  }
  std::sort(vertices.begin(), end);
  end = std::unique(vertices.begin(), end);
  double min = 1.0;
  for (auto vertex = vertices.begin(); vertex != end; ++vertex)
  {
    if (open[*vertex] != 0)
    {
      return -1.0;
    }
    for (const int* edge = pointEdges.begin(*vertex); edge != pointEdges.end(*vertex); ++edge)
    {
      for (int k = 0; k < 2; ++k)
      {
        min = std::min(min, glm::dot(axis, sites.faceNormal(edgeFaces[*edge][k])));
      }
    }
  }
  return min;
}

std::vector<int> SharedSites::elements(const SiteSet& sites) const
{
  std::vector<int> elements(sites.faceCount());
  std::iota(elements.begin(), elements.end(), 0);
  for (int site = sites.firstEdge(); site < sites.size(); ++site)
  {
    const int owner = site < sites.firstVertex() ? edgeOwners[site - sites.firstEdge()]
                                                 : vertexOwners[site - sites.firstVertex()];
    if (owner == site)
    {
      elements.push_back(site);
    }
  }
  return elements;
}

} // namespace medial
