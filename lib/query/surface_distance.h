#pragma once

#include "balls/bounding_tree.h"
#include "sites/closest_point.h"
#include "sites/site_set.h"

#include <glm/glm.hpp>

#include <vector>

namespace medial
{

/// Exact distances from arbitrary points to a mesh, in double precision. Queries may come from
/// several threads at once.
class SurfaceDistance
{
public:
  SurfaceDistance(const TriangleMesh& mesh, const MeshConnectivity& connectivity);

  /// Whether the mesh is closed and consistently oriented, so that it has an inside.
  bool knowsInside() const { return !normals_.empty(); }

  /// @param x world coordinates.
  /// @return world units; negative inside where that is known.
  double signedDistance(const glm::dvec3& x) const;

private:
  GridFrame frame_;
  SiteSet sites_;
  std::vector<glm::vec4> normals_; ///< pseudonormals; empty where there is no inside
  std::vector<int> items_;         ///< the sites that the tree is over
  BoundingTree tree_;
};

} // namespace medial
