#pragma once

#include "medial/closest_feature.h"
#include "medial/mesh_connectivity.h"
#include "medial/triangle_mesh.h"

#include <cstdint>

namespace medial
{

/// What sites are in the caller's mesh. Needs no SiteSet; ids are the same.
class SiteCells
{
public:
  /// @param mesh, connectivity must outlive this.
  SiteCells(const TriangleMesh& mesh, const MeshConnectivity& connectivity)
    : mesh_(mesh)
    , connectivity_(connectivity)
    , firstEdge_(static_cast<int>(mesh.triangleCells.size()))
    , firstVertex_(firstEdge_ + static_cast<int>(connectivity.edgeCells.size()))
  {
  }

  Feature featureOf(int site) const
  {
    return site < firstEdge_ ? Feature::Face
                             : (site < firstVertex_ ? Feature::Edge : Feature::Vertex);
  }

  /// Returns an input cell that contains the site.
  std::int64_t cellOf(int site) const
  {
    switch (this->featureOf(site))
    {
      case Feature::Face:
        return mesh_.triangleCells[site];
      case Feature::Edge:
        return connectivity_.edgeCells[site - firstEdge_];
      case Feature::Vertex:
        break;
    }
    return connectivity_.pointCells[site - firstVertex_];
  }

private:
  const TriangleMesh& mesh_;
  const MeshConnectivity& connectivity_;
  int firstEdge_;
  int firstVertex_;
};

} // namespace medial
