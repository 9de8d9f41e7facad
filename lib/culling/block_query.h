#pragma once

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
  /// Questions that lie close together.
  struct Block
  {
    Question** begin;
    Question** end;

    std::ptrdiff_t size() const { return end - begin; }
  };

  /// The groups near a position, with the squared distances of their elements.
  struct Near
  {
    std::vector<int> groups;
    std::vector<float> squared; ///< kLanes for each group
  };

  /// A pack with elements that may be closest to a position.
  struct NearPack
  {
    int pack;
    unsigned lanes;            ///< of these elements, as bits
    SiteGroup::IntLanes parts; ///< their sites that may be, as bits of SitePart
  };

  /// Boxes around eight packs, side by side.
  struct alignas(32) PackBoxes
  {
    SiteGroup::Lanes3 centre;
    SiteGroup::Lanes3 half;

    /// Sets the box around the elements of a pack.
    void set(int lane, const SiteGroup& pack);
  };

  /// Gives every question a known point.
  void prepare();
  /// @param near groups for all of the block; null if none have been collected.
  void answer(const Block& block, const GroupList* near);
  void searchEach(const Block& block) const;
  static BoxReach reachOf(const Block& block, float slack);
  /// Returns what is known of the closest site before any other is tried.
  NearestSite startOf(const Question& question) const;
  void answerFrom(const GroupList& groups, Question& question);
  /// Copies the elements of the groups found in a list that can be closest to some position in the
  /// block.
  void pack(const GroupList& list, const BoxReach& reach);
  void answerFromPacks(const Block& block, const BoxReach& reach);
  static int packsNear(const SiteGroup* packs, const PackBoxes* boxes, int count, float extent,
    const glm::vec3& x, float distance, float slack, NearPack* near);

  const SiteQuery& query_;
  const GroupTree& tree_;
  std::vector<Question*> order_;
  GroupList collected_;    ///< near some blocks
  std::vector<int> found_; ///< places of those near a block
  GroupList groups_;       ///< where these are many
  Near near_;
  std::vector<SiteGroup> packs_; ///< elements near the block, relative to its centre
  std::vector<PackBoxes> boxes_; ///< around them
  int packed_ = 0;               ///< number of elements in them
  float extent_ = 0.0f;          ///< largest distance of their corners from the centre
  std::vector<NearPack> nearPacks_;
};

} // namespace medial
