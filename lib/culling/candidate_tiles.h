#pragma once

#include "medial/common/grid.h"
#include "medial/culling/candidate_filter.h"
#include "medial/sites/grid_frame.h"
#include "medial/sites/site_set.h"

#include <cstddef>
#include <vector>

namespace medial
{

/// Leaf tiles of grid points, each with the sites that can be closest inside the tile's hull.
struct CandidateTiles
{
  std::vector<Extent> tiles;
  std::vector<std::size_t> offsets{ 0 }; ///< of each tile's candidates, one more than tiles
  std::vector<int> candidates;           ///< site ids, ascending within a tile
};

/// Finds candidates top down over an octree of tiles (Lipschitz bound and half-spaces of sites).
/// The upper levels are done once, the lower ones slab by slab, so that memory stays bounded.
class CandidateHierarchy
{
public:
  /// Grid points along the sides of a leaf tile.
  static constexpr int kLeafSize = 8;
  /// Grid points along x and y of the blocks that the upper levels end with.
  static constexpr int kBlockSize = 64;

  /// @param extent part of the grid to cover.
  /// @param slabSlices z size of a slab, a power of two up to kBlockSize. Below kLeafSize it is the
  /// z
  ///   size of the leaf tiles too.
  CandidateHierarchy(const SiteSet& sites, const GridFrame& frame, const Extent& extent,
    int slabSlices);

  /// Largest size of a leaf tile; tiles start at multiples of it from the extent's corner.
  const glm::ivec3& leafSize() const { return leafSize_; }
  int slabCount() const { return blockCounts_.z; }
  /// The part of the extent that slab `slab` covers.
  Extent slabExtent(int slab) const;
  /// The leaf tiles of a slab, in one list per block, for the hull of each tile's grid points.
  /// @param cells if not null, set to the same tiles for the hull of their grid cells, that is up
  ///   to the first points of the next tiles, so that there are no gaps between them.
  std::vector<CandidateTiles> slabTiles(int slab,
    std::vector<CandidateTiles>* cells = nullptr) const;

private:
  struct Block
  {
    Extent extent;
    std::vector<int> candidates;
  };

  FrameBox pointHull(const Extent& extent) const;
  FrameBox cellHull(const Extent& extent) const;
  void descendToBlocks(const Extent& node, const std::vector<int>& parent);
  void descendToLeaves(const Extent& node, const std::vector<int>& parent, CandidateTiles& tiles,
    CandidateTiles* cells, CandidateFilter::Scratch& scratch) const;
  void addLeaf(const Extent& tile, const FrameBox& hull, const std::vector<int>& parent,
    CandidateTiles& tiles, CandidateFilter::Scratch& scratch) const;

  CandidateFilter filter_;
  GridFrame frame_;
  Extent extent_;
  glm::ivec3 leafSize_;
  glm::ivec3 blockSize_;
  glm::ivec3 blockCounts_;
  std::vector<Block> blocks_; ///< x fastest
};

} // namespace medial
