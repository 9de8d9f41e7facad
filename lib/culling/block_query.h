#pragma once

#include "culling/group_list.h"
#include "culling/group_tree.h"
#include "culling/site_query.h"

#include <cstddef>
#include <vector>

namespace medial
{

/// Finds exact closest points of many positions, block by block: the elements near a block of
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
  /// Questions that lie close together.
  struct Block
  {
    Question** begin;
    Question** end;

    std::ptrdiff_t size() const { return end - begin; }
  };

  /// Gives every question a known point.
  void prepare();
  void answer(const Block& block);
  void searchEach(const Block& block) const;
  BoxReach reachOf(const Block& block) const;
  /// Copies the elements of the block's groups that can be closest to some position in it.
  void pack(const BoxReach& reach);
  void answerFromPacks(const Block& block, const BoxReach& reach);

  const SiteQuery& query_;
  const GroupTree& tree_;
  std::vector<Question*> order_;
  GroupList groups_;             ///< near the block
  std::vector<SiteGroup> packs_; ///< elements near the block, relative to its centre
  int packed_ = 0;               ///< number of elements in them
  float extent_ = 0.0f;          ///< largest distance of their corners from the centre
  std::vector<float> squared_;   ///< distances of one position from the packed elements
};

} // namespace medial
