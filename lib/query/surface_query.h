#pragma once

#include "culling/group_tree.h"
#include "culling/site_query.h"
#include "medial/mesh_connectivity.h"
#include "sign/surface_orientation.h"
#include "sites/closest_point.h"
#include "sites/site_set.h"

#include <glm/glm.hpp>

#include <limits>
#include <optional>
#include <vector>

namespace medial
{

/// Finds exact closest surface points of a mesh, in double precision, from anywhere, without a
/// grid. Several threads may query it at once.
class SurfaceQuery
{
public:
  /// @param margin see LocalCoordinates::around().
  SurfaceQuery(const TriangleMesh& mesh, const MeshConnectivity& connectivity, double margin);
  /// A part of a larger mesh, where each rank has one.
  /// @param local, bounds of the whole mesh.
  /// @param mesh some triangles, which face the way of orientSurface() of the whole.
  /// @param elements the triangles that closest points count of; all triangles around their corners
  ///   must be here.
  SurfaceQuery(const LocalCoordinates& local, const TriangleMesh& mesh,
    const MeshConnectivity& connectivity, const Bounds& bounds, const std::vector<int>& elements);

  const LocalCoordinates& local() const { return local_; }
  /// In local coordinates; the triangles face the way of orientSurface().
  const SiteSet& sites() const { return sites_; }

  /// Returns the closest surface point; its site is -1 if there is none within the limit.
  /// @param x local coordinates.
  /// @param limit local units; surface points at this distance or beyond do not count.
  SitePoint closest(const glm::dvec3& x,
    double limit = std::numeric_limits<double>::infinity()) const
  {
    return query_.closestWithin(x, limit);
  }

  /// Returns the unit pseudonormal of a site; zero if the site has no triangle. It points outwards
  /// where orientSurface() knows the way.
  glm::dvec3 normal(int site) const { return glm::dvec3(normals_[site]); }

  /// Returns the distance to the surface, world units; infinite if nothing is found, as at
  /// coordinates that are not numbers.
  /// @param x world coordinates.
  double distance(const Point3& x) const;

private:
  /// @param turnedMesh the mesh whose triangles face the same way; empty if they do already.
  SurfaceQuery(const TriangleMesh& mesh, const MeshConnectivity& connectivity, double margin,
    const std::optional<OrientedMesh>& turnedMesh);
  SurfaceQuery(const LocalCoordinates& local, const TriangleMesh& mesh,
    const MeshConnectivity& connectivity);

  LocalCoordinates local_;
  SiteSet sites_;
  std::vector<glm::vec4> normals_; ///< pseudonormals()
  GroupTree tree_;
  SiteQuery query_;
};

} // namespace medial
