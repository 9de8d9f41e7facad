#pragma once

#include "base/run.h"
#include "culling/group_tree.h"
#include "culling/site_query.h"
#include "medial/mesh_connectivity.h"
#include "medial/sign_method.h"
#include "medial/triangle_mesh.h"
#include "query/point_side.h"
#include "sites/closest_point.h"
#include "sites/local_coordinates.h"
#include "sites/site_cells.h"
#include "sites/site_set.h"

#include <glm/glm.hpp>

namespace medial
{

/// A mesh that is ready for the signed distances of any points. Several threads may query it at
/// once.
class DistanceQuery
{
public:
  /// @param mesh taken over.
  /// @throws Error InvalidInput for a mesh without cells, and for a sign that it does not allow.
  DistanceQuery(TriangleMesh mesh, SignMethod sign, const Run& run, const Execution& execution);
  DistanceQuery(const DistanceQuery&) = delete;
  DistanceQuery& operator=(const DistanceQuery&) = delete;

  /// The local coordinates of a mesh's query, before there is one.
  /// @throws Error InvalidInput for a mesh without cells.
  static LocalCoordinates localOf(const TriangleMesh& mesh);

  const TriangleMesh& mesh() const { return mesh_; }
  const MeshConnectivity& connectivity() const { return connectivity_; }
  const SignReport& sign() const { return side_.report(); }
  const LocalCoordinates& local() const { return local_; }
  const SiteSet& sites() const { return sites_; }
  const SiteCells& cells() const { return cells_; }
  /// Closest surface points, local coordinates.
  const SiteQuery& query() const { return query_; }
  const PointSide& side() const { return side_; }

  /// A search for points that become known one after the other: what is known of one helps with
  /// the next. The answers do not depend on it.
  class Search
  {
  public:
    explicit Search(const DistanceQuery& query)
      : query_(query)
    {
    }

    /// Returns the closest surface point, local coordinates.
    const SitePoint& closest(const glm::dvec3& x);

  private:
    const DistanceQuery& query_;
    SitePoint closest_;
  };

private:
  TriangleMesh mesh_;
  LocalCoordinates local_;
  MeshConnectivity connectivity_;
  SiteSet sites_;
  GroupTree tree_;
  SiteQuery query_;
  SiteCells cells_;
  PointSide side_;
};

} // namespace medial
