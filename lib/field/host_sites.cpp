#include "field/host_sites.h"

#include "base/stopwatch.h"
#include "sites/pseudonormals.h"

#include <utility>

namespace medial
{

HostSites::HostSites(const TriangleMesh& mesh, const MeshConnectivity& connectivity,
  const GridFrame& frame, FieldSign sign, const Run& run, RunStatistics& statistics)
  : HostSites(mesh, connectivity, frame, sign, run, statistics, {})
{
}

HostSites::HostSites(const TriangleMesh& mesh, const MeshConnectivity& connectivity,
  const GridFrame& frame, FieldSign sign, const Run& run, RunStatistics& statistics,
  TreeMaker makeTree)
  : mesh_(mesh)
  , connectivity_(connectivity)
  , frame_(frame)
  , sign_(sign)
  , run_(run)
  , statistics_(statistics)
  , makeTree_(std::move(makeTree))
{
}

const SiteSet& HostSites::sites() const
{
  if (!sites_)
  {
    const Stopwatch watch(statistics_.seconds.sites);
    run_.onThreads([&] { sites_.emplace(mesh_, connectivity_, frame_); });
  }
  return *sites_;
}

const CandidateFilter& HostSites::filter() const
{
  if (!filter_)
  {
    const SiteSet& sites = this->sites();
    const Stopwatch watch(statistics_.seconds.cull);
    run_.onThreads(
      [&]
      {
        if (makeTree_)
        {
          filter_.emplace(sites, connectivity_, makeTree_(sites));
        }
        else
        {
          filter_.emplace(sites, connectivity_, frame_);
        }
      });
  }
  return *filter_;
}

void HostSites::forgetFilter()
{
  if (filter_)
  {
    filter_->forget();
  }
}

const SiteQuery& HostSites::query() const
{
  if (!query_)
  {
    query_.emplace(this->filter().tree());
  }
  return *query_;
}

const std::vector<glm::vec4>& HostSites::normals() const
{
  if (!normals_)
  {
    const SiteSet& sites = this->sites();
    const Stopwatch watch(statistics_.seconds.sites);
    normals_ = pseudonormals(sites, sign_ == FieldSign::Inward);
  }
  return *normals_;
}

const std::vector<glm::vec4>& HostSites::signNormals() const
{
  return hasPseudonormals(sign_) ? this->normals() : none_;
}

} // namespace medial
