#pragma once

#include "base/box.h"

#include <glm/glm.hpp>

#include <array>
#include <vector>

namespace medial
{

/// A binary tree of boxes over elements that move: it is built once and refitted for every frame.
/// Elements lie in the order of the leaves, each in a slot of its own.
class BoxTree
{
public:
  /// A leaf has the elements in slots first .. first + count - 1. An inner node has count 0; its
  /// first child follows it.
  struct Node
  {
    Box box;
    int second = 0; ///< the other child of an inner node
    int first = 0;
    int count = 0;

    bool leaf() const { return count > 0; }
  };

  /// @param corners per element: its points, repeated for segments and points.
  void build(const std::vector<glm::dvec3>& points, const std::vector<glm::ivec3>& corners);
  /// Fits the boxes to moved points. Uses the threads of the current arena.
  void refit(const std::vector<glm::dvec3>& points);

  const std::vector<Node>& nodes() const { return nodes_; }
  /// Calls visit(leaf) for the leaves whose boxes, with all those above them, pass a test.
  template <typename Passes, typename Visit>
  void visitLeaves(const Passes& passes, const Visit& visit) const
  {
    std::array<int, 64> stack; // every level adds one, and halves 2^31 elements
    int count = 0;
    stack[count++] = 0;
    while (count > 0)
    {
      const int node = stack[--count];
      if (!passes(nodes_[node].box))
      {
        continue;
      }
      if (nodes_[node].leaf())
      {
        visit(nodes_[node]);
        continue;
      }
      stack[count++] = nodes_[node].second;
      stack[count++] = node + 1;
    }
  }

  const Box& box() const { return nodes_.front().box; }
  /// The element of every slot.
  const std::vector<int>& elements() const { return elements_; }
  /// Whether the boxes have grown so much since they were built that a new tree is worth it.
  bool worn() const;

private:
  struct Range
  {
    int begin;
    int end;
  };

  void split(const std::vector<Box>& boxes, int node, int begin, int end);
  /// Lists the points of every leaf and the parts that are refitted side by side.
  void prepareRefit(const std::vector<glm::ivec3>& corners);
  void addParts(int node, int end, int largest);
  void refitNode(int node, const std::vector<glm::dvec3>& points);
  double cost() const;

  std::vector<Node> nodes_;
  std::vector<int> elements_;
  std::vector<int> leafPoints_;  ///< points of the leaves, each once in a leaf
  std::vector<int> leafOffsets_; ///< per node and the end: its part of leafPoints_
  std::vector<Range> parts_;     ///< nodes of subtrees
  std::vector<int> top_;         ///< the nodes above them, lower ones last
  double builtCost_ = 0.0;
};

} // namespace medial
