#pragma once

#include "base/run.h"
#include "culling/candidate_filter.h"
#include "culling/site_query.h"
#include "field/field_sign.h"
#include "medial/mesh_connectivity.h"
#include "medial/run_statistics.h"
#include "medial/triangle_mesh.h"
#include "sites/grid_frame.h"
#include "sites/site_set.h"

#include <glm/glm.hpp>

#include <functional>
#include <optional>
#include <vector>

namespace medial
{

/// The sites of a mesh in host memory, and what is made of them, each when it is first asked for:
/// an engine on a device needs none. Asking for the first time is for one thread.
class HostSites
{
public:
  /// @param mesh, connectivity, statistics must outlive this; the statistics get the seconds.
  HostSites(const TriangleMesh& mesh, const MeshConnectivity& connectivity, const GridFrame& frame,
    FieldSign sign, const Run& run, RunStatistics& statistics);

  /// Makes the tree of elements from some sites.
  using TreeMaker = std::function<GroupTree(const SiteSet& sites)>;
  /// @param makeTree of a part of a larger surface.
  HostSites(const TriangleMesh& mesh, const MeshConnectivity& connectivity, const GridFrame& frame,
    FieldSign sign, const Run& run, RunStatistics& statistics, TreeMaker makeTree);

  const SiteSet& sites() const;
  const CandidateFilter& filter() const;
  /// Frees memory that fields take, and queries don't, until there is another field.
  void forgetFilter();
  /// Exact closest points.
  const SiteQuery& query() const;
  /// pseudonormals() of all sites, turned outwards.
  const std::vector<glm::vec4>& normals() const;
  /// The same if they give the sign, otherwise empty.
  const std::vector<glm::vec4>& signNormals() const;

private:
  const TriangleMesh& mesh_;
  const MeshConnectivity& connectivity_;
  GridFrame frame_;
  FieldSign sign_;
  Run run_;
  RunStatistics& statistics_;
  TreeMaker makeTree_; ///< empty for a whole surface
  std::vector<glm::vec4> none_;
  mutable std::optional<SiteSet> sites_;
  mutable std::optional<CandidateFilter> filter_;
  mutable std::optional<SiteQuery> query_;
  mutable std::optional<std::vector<glm::vec4>> normals_;
};

} // namespace medial
