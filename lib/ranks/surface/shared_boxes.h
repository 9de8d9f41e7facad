#pragma once

#include "base/box.h"
#include "base/box_tree.h"
#include "base/sorted_set.h"
#include "ranks/collective.h"

#include <vector>

namespace medial
{

/// Boxes around parts of a surface, and which other ranks have these parts.
class SharedBoxes
{
public:
  /// Every rank calls it.
  /// @param own boxes around what this rank has.
  SharedBoxes(Communicator& communicator, const std::vector<Box>& own);

  /// Returns the other ranks that have a box for which passes(box) is true, ascending.
  /// @param passes must be true for a box if it is for one inside.
  template <typename Passes>
  std::vector<int> ranksWith(const Passes& passes) const
  {
    std::vector<int> ranks;
    if (ranks_.empty())
    {
      return ranks;
    }
    tree_.visitLeaves(passes,
      [&](const BoxTree::Node& leaf)
      {
        for (int slot = leaf.first; slot < leaf.first + leaf.count; ++slot)
        {
          const int box = tree_.elements()[slot];
          if (passes(boxes_[box]))
          {
            ranks.push_back(ranks_[box]);
          }
        }
      });
    makeSet(ranks);
    return ranks;
  }

private:
  std::vector<Box> boxes_; ///< of other ranks
  std::vector<int> ranks_; ///< that have them
  BoxTree tree_;
};

} // namespace medial
