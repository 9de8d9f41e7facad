#pragma once

#include "base/checkpoint.h"
#include "culling/candidate_filter.h"
#include "culling/closest_seeds.h"
#include "medial/grid.h"
#include "sites/grid_frame.h"
#include "sites/site_set.h"

#include <cstddef>
#include <functional>
#include <vector>

namespace medial
{

/// Leaf tiles of grid points with their candidates: the sites that can be closest inside the hull
/// of the tile.
struct CandidateTiles
{
  std::vector<Extent> tiles;
  std::vector<std::size_t> offsets{ 0 }; ///< offsets of each tile's candidates, one more than tiles
  std::vector<int> candidates;           ///< site ids, ascending within a tile
};

/// Where the candidates of a tile are complete.
enum class TileHull
{
  Points, ///< at its grid points and between them
  Cells ///< also up to the first points of the next tiles, so that there are no gaps between tiles
};

/// Finds candidates top-down over an octree of tiles. The upper levels are computed once, the lower
/// ones region by region, so that memory stays bounded.
class CandidateHierarchy
{
public:
  /// Largest number of grid points along an edge of a leaf tile.
  static constexpr int kLeafSize = 8;
  /// Number of grid points along an edge of the blocks, where the upper levels end. Blocks start at
  /// multiples of it, counted from the extent's corner.
  static constexpr int kBlockSize = 32;

  /// Called from several threads at once.
  /// @param candidates ascending.
  using Visitor = std::function<void(const Extent& tile, const std::vector<int>& candidates)>;

  /// @param filter over all sites; must outlive this.
  /// @param extent part of the grid to cover.
  /// @param seeds of an earlier frame, must outlive this; may be null.
  CandidateHierarchy(const CandidateFilter& filter, const GridFrame& frame, const Extent& extent,
    TileHull hull, const ClosestSeeds* seeds = nullptr);

  /// Returns the layers of blocks, with all their slices, that contain a slab. Candidates are only
  /// found for whole layers: those of a part would be others, and so would be the last bits of
  /// results.
  Extent layersOf(const Extent& slab) const;

  /// Visits the leaf tiles of whole layers, on all threads of the current arena. Tiles start at
  /// multiples of kLeafSize, counted from the extent's corner.
  /// @param layers of layersOf().
  void visitLeaves(const Extent& layers, const Visitor& visitor) const;

  /// Lists the leaf tiles of whole layers, in one list per block.
  /// @param layers of layersOf().
  /// @param checkpoint called for each block; may be null.
  std::vector<CandidateTiles> leafTiles(const Extent& layers,
    const Checkpoint* checkpoint = nullptr) const;

  /// Memory that the candidates of the blocks take.
  std::size_t blockBytes() const;

private:
  struct Block
  {
    Extent extent;
    std::vector<int> candidates;
  };
  struct Workspace;

  struct Parts;

  FrameBox hullOf(const Extent& extent) const;
  void divide(const Extent& node, const glm::ivec3& limit, Parts& parts) const;
  void descendToBlocks(const Extent& node, const std::vector<int>& candidates);
  void descendToLeaves(const Extent& node, const std::vector<int>& candidates, int depth,
    Workspace& workspace, const Visitor& visitor) const;
  std::vector<const Block*> blocksOf(const Extent& layers) const;

  const CandidateFilter& filter_;
  GridFrame frame_;
  Extent extent_;
  TileHull hull_;
  const ClosestSeeds* seeds_;
  glm::ivec3 blockCounts_;
  std::vector<Block> blocks_; ///< x fastest
};

} // namespace medial
