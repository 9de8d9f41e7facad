#pragma once

#include "culling/block_positions.h"
#include "culling/group_list.h"
#include "culling/group_tree.h"
#include "culling/nearest_site.h"
#include "culling/site_query.h"

#include <cstddef>
#include <vector>

namespace medial
{

/// Finds exact closest points of many positions, block by block: the groups near a block of
/// neighbouring positions are found once, and each position chooses from these. Memory of one
/// thread.
class BlockQuery
{
public:
  using Question = SiteQuery::Question;

  /// @param query, tree must outlive this; the query is over the tree.
  BlockQuery(const SiteQuery& query, const GroupTree& tree);

  /// Answers questions as SiteQuery::closest() does.
  void answer(std::vector<Question>& questions);

private:
  /// A question, and the distance of its known point, rounded up.
  struct Asked
  {
    Question* question;
    float known;
  };
  /// The box around some questions, by its corners.
  struct Bounds
  {
    glm::dvec3 low;
    glm::dvec3 high;

    double size() const;
    FrameBox box() const;
  };
  /// Questions that lie close together.
  struct Block
  {
    Asked* begin;
    Asked* end;
    std::size_t bounds; ///< number of its bounds; those of its halves have twice that, plus 1 and 2

    std::ptrdiff_t size() const { return end - begin; }
    /// The middle is at full packs of positions.
    Asked* middle() const { return begin + (this->size() / 2 + kLanes - 1) / kLanes * kLanes; }
    Block first() const { return { begin, this->middle(), 2 * bounds + 1 }; }
    Block second() const { return { this->middle(), end, 2 * bounds + 2 }; }
  };

  /// The groups near a position, with the squared distances of their elements.
  struct Near
  {
    std::vector<int> groups;
    std::vector<float> squared; ///< kLanes for each
  };

  /// Gives every question a known point.
  void prepare();
  /// Sets the bounds of a block and of its parts.
  void bound(const Block& block);
  /// Orders questions so that both halves are compact. Mostly they are as they come.
  void halve(const Block& block);
  /// @param near groups for all of the block; null if none have been collected.
  void answer(const Block& block, const std::vector<GroupPack>* near);
  void searchEach(const Block& block) const;
  BoxReach reachOf(const Block& block) const;
  /// Returns what is known of the closest site before any other is tried.
  NearestSite startOf(const Question& question) const;
  void answerFrom(const GroupList& groups, const Asked& asked);
  /// Narrows groups down to those near a block. Returns their number.
  int findNear(const BoxReach& reach, const std::vector<GroupPack>& groups);
  /// Answers all questions of a block at once.
  void answerTogether(const Block& block, const BoxReach& reach);
  /// Offers sites of a group to the questions of a block.
  void offer(const SiteGroup& group, const BlockPositions::Near& near);

  const SiteQuery& query_;
  const GroupTree& tree_;
  std::vector<Asked> order_;
  std::vector<Bounds> bounds_;
  std::vector<GroupPack> collected_; ///< groups near some blocks
  std::vector<GroupPack> found_;     ///< those near one block
  GroupList groups_;                 ///< where these are many
  Near near_;
  BlockPositions positions_;
  std::vector<NearestSite> nearest_; ///< to these
  BlockPositions::NearList nearSites_;
};

} // namespace medial
