#pragma once

#include "culling/group_tree.h"
#include "culling/node_disc.h"
#include "ranks/surface/element_sharing.h"
#include "ranks/surface/surface_part.h"
#include "ranks/surface/tree_records.h"
#include "sites/grid_frame.h"
#include "sites/site_set.h"

#include <glm/glm.hpp>

#include <array>
#include <memory>
#include <optional>
#include <vector>

namespace medial
{

/// What a rank needs of the surface to find the closest places of its grid points.
struct NearSurface
{
  SurfacePart part;
  float slack;                   ///< of the whole surface's tree
  std::vector<SparseTree> trees; ///< over the triangles of the part
};

/// The tree of a distributed surface's elements: each rank has the lower nodes of its blocks, and
/// all have the few nodes above the blocks.
class SharedTree
{
public:
  /// Every rank calls it.
  /// @param surface must outlive this.
  SharedTree(Communicator& communicator, const DistributedSurface& surface, const GridFrame& frame);

  /// Returns all triangles, with their neighbours, that can be closest somewhere in some boxes.
  /// Every rank calls it, with its own boxes. What a rank only needs to answer others is dropped
  /// before, and made anew when it is called again.
  NearSurface near(Communicator& communicator, const std::vector<FrameBox>& boxes);

private:
  /// A block, as all ranks know it.
  struct Block
  {
    NodeDisc disc;
    glm::dvec3 point; ///< some point of the surface there
  };
  /// A box, how far from its centre closest points can be, and some surface points near it.
  struct Search
  {
    FrameBox box;
    float distance;
    int pointCount;
    std::array<glm::vec3, FrameBox::kCorners> points;

    BoxReach reach() const;
  };
  /// The surface points that are nearest to the centre and the corners of a box.
  struct Nearest
  {
    std::array<float, 1 + FrameBox::kCorners> squared; ///< distances
    std::array<int, 1 + FrameBox::kCorners> face;      ///< numbers of the elements
    std::array<glm::vec3, 1 + FrameBox::kCorners> point;
  };
  /// The surface of this rank's blocks.
  struct Own
  {
    SurfacePart part;
    SiteSet sites;
    std::optional<GroupTree> tree; ///< over this rank's groups; none without

    Own(SurfacePart surface, const GridFrame& frame);
  };

  std::unique_ptr<Own> fetchOwn(Communicator& communicator, std::vector<int> points) const;
  /// Returns the corners of this rank's elements.
  std::vector<int> cornersOfOwn(Communicator& communicator) const;
  void buildBlocks(Communicator& communicator);
  Block buildBlock(const SharedSites& shared, const SharedElement* begin, const SharedElement* end,
    int tree);
  void buildTop(const std::vector<Block>& blocks);
  void buildOwnTree();
  int levelsOfBlock(int tree) const;
  /// Returns upper bounds of the distances from the centres of boxes.
  std::vector<float> bounds(const std::vector<FrameBox>& boxes) const;
  /// Returns for each rank which searches its blocks may answer.
  RankLists<int> ranksOf(const std::vector<Search>& searches) const;
  /// Finds the points nearest to a box, of those of this rank.
  Nearest nearestTo(const FrameBox& box) const;
  /// Replaces the distances by exact ones, and adds the points nearest to the corners.
  void sharpen(Communicator& communicator, std::vector<Search>& searches) const;
  /// Answers searches by the groups, packs and triangles of this rank.
  void answer(const std::vector<Search>& searches, std::vector<GroupRecord>& groups,
    std::vector<PackRecord>& packs, std::vector<int>& faces) const;

  const DistributedSurface& surface_;
  GridFrame frame_;
  int ranks_;
  float slack_;
  SharedElements elements_;         ///< its list is empty once groups_ is made
  std::vector<GroupRecord> groups_; ///< of this rank's blocks, ascending
  std::vector<PackRecord> packs_;   ///< the lower nodes of this rank's blocks
  std::vector<PackRecord> top_;     ///< the upper nodes, of all blocks
  std::vector<Block> blocks_;       ///< of all ranks
  std::unique_ptr<Own> own_;        ///< null once near() has been called
};

} // namespace medial
