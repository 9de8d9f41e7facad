#include "culling/candidate_tiles.h"

#include "base/extents.h"
#include "culling/extent_hull.h"

#include <tbb/parallel_for.h>

#include <algorithm>

namespace medial
{
namespace
{

/// Number of grid points along an edge of a set of tiles.
constexpr int kSetSize = 2 * CandidateHierarchy::kTileSize;

/// Number of groups of a set up to which lists of sites are quicker than groups.
constexpr int kFewGroups = 100;

bool cuts(const Extent& slab, const Extent& part)
{
  return !commonPart(slab, part).empty();
}

bool wants(const CandidateHierarchy::Visitor& visitor, const Extent& slab, const Extent& tiles)
{
  return cuts(slab, tiles) && (!visitor.wanted || visitor.wanted(tiles));
}

} // namespace

CandidateHierarchy::CandidateHierarchy(const CandidateFilter& filter, const GridFrame& frame,
  const Extent& whole, const Extent& extent)
  : filter_(filter)
  , frame_(frame)
  , whole_(whole)
  , extent_(extent)
{
}

std::vector<Extent> CandidateHierarchy::setsOf(const Extent& slab) const
{
  Extent part = extent_;
  part.min[2] = slab.min[2];
  part.max[2] = slab.max[2];
  std::vector<Extent> sets;
  visitParts(wholeParts(part, kSetSize, whole_), kSetSize,
    [&](const Extent& set) { sets.push_back(set); });
  return sets;
}

CullingCounts CandidateHierarchy::visitTiles(const Extent& slab, const Visitor& visitor) const
{
  const std::vector<Extent> sets = this->setsOf(slab);
  Workspaces workspaces;
  tbb::parallel_for(std::size_t{ 0 }, sets.size(),
    [&](std::size_t i)
    {
      if (!wants(visitor, slab, sets[i]))
      {
        return;
      }
      Workspace& workspace = workspaces.local();
      const BoxReach reach = this->collectGroups(sets[i], workspace);
      if (workspace.shared.size() <= kFewGroups)
      {
        this->visitSites(sets[i], reach, slab, workspace, visitor);
        return;
      }
      visitParts(sets[i], kTileSize,
        [&](const Extent& tile)
        {
          if (wants(visitor, slab, tile))
          {
            this->visitGroups(tile, workspace, visitor);
          }
        });
    });
  return sumOf(workspaces);
}

CullingCounts CandidateHierarchy::sumOf(const Workspaces& workspaces)
{
  CullingCounts sum;
  for (const Workspace& workspace : workspaces)
  {
    sum.groupTests += workspace.counts.groupTests;
    sum.siteTests += workspace.counts.siteTests;
  }
  return sum;
}

BoxReach CandidateHierarchy::collectGroups(const Extent& set, Workspace& workspace) const
{
  const GroupTree& tree = filter_.tree();
  const FrameBox hull = hullOf(set, frame_);
  const NearestElement nearest = tree.nearest(glm::dvec3(hull.centre));
  BoxReach reach(hull, nearest, tree.slack());
  addCorners(
    tree, nearest,
    [&](const glm::dvec3& x, const NearestElement& start) { return tree.nearest(x, start); },
    reach);
  workspace.counts.groupTests += tree.collect(reach, workspace.shared);
  return reach;
}

void CandidateHierarchy::visitSites(const Extent& set, const BoxReach& reach, const Extent& slab,
  Workspace& workspace, const Visitor& visitor) const
{
  workspace.tiles.clear();
  workspace.hulls.clear();
  visitParts(set, kTileSize,
    [&](const Extent& tile)
    {
      if (wants(visitor, slab, tile))
      {
        workspace.tiles.push_back(tile);
        workspace.hulls.push_back(hullOf(tile, frame_));
      }
    });
  workspace.counts.siteTests += filter_.listSites(reach, workspace.shared, workspace.hulls.data(),
    static_cast<int>(workspace.hulls.size()), workspace.sites.data(), workspace.scratch);
  for (std::size_t i = 0; i < workspace.tiles.size(); ++i)
  {
    visitor.sites(workspace.tiles[i], workspace.sites[i]);
  }
}

void CandidateHierarchy::visitGroups(const Extent& tile, Workspace& workspace,
  const Visitor& visitor) const
{
  NearestElement nearest;
  workspace.counts.groupTests += workspace.shared.size();
  const BoxReach reach =
    refine(filter_.tree(), workspace.shared, hullOf(tile, frame_), nearest, workspace.own);
  visitor.groups(tile, reach, workspace.own);
}

} // namespace medial
