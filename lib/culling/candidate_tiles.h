#pragma once

#include "culling/candidate_filter.h"
#include "culling/group_list.h"
#include "medial/grid.h"
#include "sites/grid_frame.h"

#include <tbb/enumerable_thread_specific.h>

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

namespace medial
{

/// What finding candidates took.
struct CullingCounts
{
  std::int64_t groupTests = 0; ///< pairs of a disc and a set of tiles or a tile that were tested
  std::int64_t siteTests = 0;  ///< pairs of a site and a tile
};

/// Finds the candidates of tiles, the sites that can be closest in their hulls, by two trees: that
/// of the elements, and that of tiles. Sets of neighbouring tiles find the groups of elements that
/// can be closest to them, and tiles find theirs among these. What is found does not depend on
/// which tiles are visited.
class CandidateHierarchy
{
public:
  /// Largest number of grid points along an edge of a tile. Tiles start at multiples of it,
  /// whatever the extent: what is computed in them is the same for any part of the grid.
  static constexpr int kTileSize = 8;

  /// Called from several threads at once.
  struct Visitor
  {
    /// Tiles with few candidates.
    /// @param sites ascending.
    std::function<void(const Extent& tile, const std::vector<int>& sites)> sites;
    /// Tiles with many.
    std::function<void(const Extent& tile, const BoxReach& reach, const GroupList& groups)> groups;
    /// Whether some of these tiles are wanted; null if all are. Others are not visited.
    std::function<bool(const Extent& tiles)> wanted = nullptr;
  };

  /// @param filter over all sites; must outlive this.
  /// @param whole all of the grid.
  /// @param extent part of the grid to cover.
  CandidateHierarchy(const CandidateFilter& filter, const GridFrame& frame, const Extent& whole,
    const Extent& extent);

  /// Visits the wanted tiles that a slab of the extent cuts, whole: they may leave the extent. Uses
  /// all threads of the current arena.
  CullingCounts visitTiles(const Extent& slab, const Visitor& visitor) const;

private:
  /// Memory of one thread.
  struct Workspace
  {
    GroupList shared; ///< groups of a set of tiles
    GroupList own;    ///< groups of one of them
    std::vector<Extent> tiles;
    std::vector<FrameBox> hulls;
    std::array<std::vector<int>, CandidateFilter::kMaxBoxes> sites; ///< of each
    CandidateFilter::Scratch scratch;
    CullingCounts counts;
  };
  using Workspaces = tbb::enumerable_thread_specific<Workspace>;

  static CullingCounts sumOf(const Workspaces& workspaces);
  std::vector<Extent> setsOf(const Extent& slab) const;
  /// Finds the groups of a set of tiles.
  BoxReach collectGroups(const Extent& set, Workspace& workspace) const;
  void visitSites(const Extent& set, const BoxReach& reach, const Extent& slab,
    Workspace& workspace, const Visitor& visitor) const;
  void visitGroups(const Extent& tile, Workspace& workspace, const Visitor& visitor) const;

  const CandidateFilter& filter_;
  GridFrame frame_;
  Extent whole_;
  Extent extent_;
};

} // namespace medial
