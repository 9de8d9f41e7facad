#pragma once

#include "medial/mesh_connectivity.h"
#include "sites/site_set.h"

#include <glm/glm.hpp>

#include <vector>

namespace medial
{

struct SiteGroup;

/// Which element owns the sites that several share, and which faces meet at edges.
struct SharedSites
{
  static constexpr int kNone = -1;

  std::vector<int> edgeOwners;       ///< element of every edge
  std::vector<int> vertexOwners;     ///< element of every vertex
  std::vector<glm::ivec2> edgeFaces; ///< the first two active faces of every edge, or kNone
  std::vector<char>
    open; ///< of every vertex: whether an edge there has not two active faces, one each way
  std::vector<char> degenerate; ///< of every vertex: whether a face or an edge there is not active
  const IncidenceLists& pointEdges; ///< of the connectivity

  /// @param connectivity must outlive this.
  SharedSites(const SiteSet& sites, const MeshConnectivity& connectivity);

  /// Returns the smallest cosine between an axis and the normals of the faces at a group's sites.
  /// @return -1 if the surface ends or branches there, or turns its other side out.
  double minCosine(const SiteSet& sites, const SiteGroup& group, const glm::dvec3& axis) const;

  /// Returns all elements, by the sites that name them: faces, and edges and vertices of no face.
  std::vector<int> elements(const SiteSet& sites) const;
};

} // namespace medial
