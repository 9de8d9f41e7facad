#pragma once

#include "base/box_tree.h"

#include <algorithm>
#include <array>
#include <tuple>
#include <vector>

namespace medial
{

/// A node of one tree and a node of another.
struct NodePair
{
  int a = 0;
  int b = 0;
  double squared = 0.0; ///< distance of their boxes
};

/// The pairs of nodes below a pair; at least one of its nodes is not a leaf.
class PairChildren
{
public:
  /// @param moved translation of A.
  PairChildren(const BoxTree& a, const BoxTree& b, const NodePair& pair,
    const glm::dvec3& moved = glm::dvec3(0.0))
  {
    const BoxTree::Node& nodeA = a.nodes()[pair.a];
    const BoxTree::Node& nodeB = b.nodes()[pair.b];
    const int inA[] = { nodeA.leaf() ? pair.a : pair.a + 1, nodeA.second };
    const int inB[] = { nodeB.leaf() ? pair.b : pair.b + 1, nodeB.second };
    for (int i = 0; i < (nodeA.leaf() ? 1 : 2); ++i)
    {
      const Box boxA = a.nodes()[inA[i]].box.moved(moved);
      for (int k = 0; k < (nodeB.leaf() ? 1 : 2); ++k)
      {
        pairs_[count_++] = { inA[i], inB[k], boxA.squaredDistance(b.nodes()[inB[k]].box) };
      }
    }
  }

  /// Puts the farthest first, so that a stack has the nearest on top.
  void sort()
  {
    for (int i = 1; i < count_; ++i)
    {
      for (int k = i; k > 0 && pairs_[k - 1].squared < pairs_[k].squared; --k)
      {
        std::swap(pairs_[k - 1], pairs_[k]);
      }
    }
  }

  const NodePair* begin() const { return pairs_.data(); }
  const NodePair* end() const { return pairs_.data() + count_; }

private:
  std::array<NodePair, 4> pairs_;
  int count_ = 0;
};

inline bool areLeaves(const BoxTree& a, const BoxTree& b, const NodePair& pair)
{
  return a.nodes()[pair.a].leaf() && b.nodes()[pair.b].leaf();
}

/// Calls visit(pair) for the pairs of leaves below a pair whose boxes are no farther apart than a
/// limit, near ones first.
/// @param limit returns the squared distance, which may fall meanwhile; a negative one ends the
///   walk.
/// @param moved translation of A.
template <typename Limit, typename Visit>
void walkPairs(const BoxTree& a, const BoxTree& b, const NodePair& start, const Limit& limit,
  const Visit& visit, const glm::dvec3& moved = glm::dvec3(0.0))
{
  // Every level of either tree adds three pairs at most, and a level halves 2^31 elements.
  std::array<NodePair, 4 * 64> stack;
  int count = 0;
  stack[count++] = start;
  while (count > 0)
  {
    const NodePair pair = stack[--count];
    if (pair.squared > limit())
    {
      continue;
    }
    if (areLeaves(a, b, pair))
    {
      visit(pair);
      continue;
    }
    PairChildren children(a, b, pair, moved);
    children.sort();
    for (const NodePair& child : children)
    {
      if (child.squared <= limit())
      {
        stack[count++] = child;
      }
    }
  }
}

/// Splits a walk into parts: pairs of nodes that cover all pairs of leaves within a limit, the
/// nearest first.
/// @param wanted how many there should be at least, if the trees are deep enough.
class WalkParts
{
public:
  void split(const BoxTree& a, const BoxTree& b, double limit, std::size_t wanted)
  {
    pairs_.clear();
    pairs_.push_back({ 0, 0, a.box().squaredDistance(b.box()) });
    for (bool deeper = true; deeper && pairs_.size() < wanted;)
    {
      deeper = this->descend(a, b, limit);
    }
    std::sort(pairs_.begin(), pairs_.end(),
      [](const NodePair& p, const NodePair& q)
      { return std::tie(p.squared, p.a, p.b) < std::tie(q.squared, q.a, q.b); });
  }

  const std::vector<NodePair>& pairs() const { return pairs_; }

private:
  /// Returns whether any pair had children.
  bool descend(const BoxTree& a, const BoxTree& b, double limit)
  {
    bool deeper = false;
    children_.clear();
    for (const NodePair& pair : pairs_)
    {
      if (areLeaves(a, b, pair))
      {
        children_.push_back(pair);
        continue;
      }
      deeper = true;
      for (const NodePair& child : PairChildren(a, b, pair))
      {
        if (child.squared <= limit)
        {
          children_.push_back(child);
        }
      }
    }
    pairs_.swap(children_);
    return deeper;
  }

  std::vector<NodePair> pairs_;
  std::vector<NodePair> children_;
};

} // namespace medial
