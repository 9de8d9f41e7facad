#pragma once

#include <glm/glm.hpp>

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace medial
{

/// What holds an item, as a ball or a hull of balls: balls of radius `reach` at most, with centres
/// in a box.
struct ItemBounds
{
  glm::dvec3 min{ 0.0 };
  glm::dvec3 max{ 0.0 };
  double reach = 0.0;

  void add(const glm::dvec3& centre, double radius);
  void add(const ItemBounds& other);
  /// No centre is nearer to x than this.
  double minCentreDistance(const glm::dvec3& x) const
  {
    return glm::length(glm::max(glm::max(min - x, x - max), glm::dvec3(0.0)));
  }
  /// No point of the item is nearer to x than this; negative where x may lie inside.
  double minDistance(const glm::dvec3& x) const { return this->minCentreDistance(x) - reach; }
  static ItemBounds nothing();
};

/// A binary tree over items, for those that are nearest to something. Items are split by the
/// position of their centres and by their size, since a large ball is near to much.
class BoundingTree
{
public:
  explicit BoundingTree(const std::vector<ItemBounds>& items);

  /// Calls `visit(item)` for items that may be nearer to x than `limit`, near ones first. `visit`
  /// lowers the limit by what it finds.
  template <typename Visit>
  void search(const glm::dvec3& x, double& limit, const Visit& visit) const
  {
    this->searchNodes([&](std::uint32_t node) { return nodes_[node].bounds.minDistance(x); }, limit,
      visit);
  }

  /// The same for another measure than the distance from a point.
  /// @param minimum of a node: the measure of its items is not below it.
  template <typename Minimum, typename Visit>
  void searchNodes(const Minimum& minimum, double& limit, const Visit& visit) const
  {
    if (nodes_.empty())
    {
      return;
    }
    Pending stack[kMaxPending];
    int pending = 0;
    stack[pending++] = { minimum(0U), 0 };
    while (pending > 0)
    {
      const Pending next = stack[--pending];
      if (next.min >= limit)
      {
        continue;
      }
      const Node& node = nodes_[next.node];
      if (node.count > 0)
      {
        for (std::uint32_t i = node.first; i < node.first + node.count; ++i)
        {
          visit(order_[i]);
        }
        continue;
      }
      Pending near{ minimum(node.first), node.first };
      Pending far{ minimum(node.first + 1), node.first + 1 };
      if (far.min < near.min)
      {
        std::swap(near, far);
      }
      stack[pending++] = far;
      stack[pending++] = near;
    }
  }

  const ItemBounds& bounds(std::uint32_t node) const { return nodes_[node].bounds; }

  /// What holds for all items of a node, for every node.
  /// @param ofItem maps an item to its value.
  /// @param join maps the values of two parts to that of both.
  template <typename Value, typename OfItem, typename Join>
  std::vector<Value> valuesOfNodes(const OfItem& ofItem, const Join& join) const
  {
    std::vector<Value> values(nodes_.size());
    for (std::size_t i = nodes_.size(); i-- > 0;) // children come after their parents
    {
      const Node& node = nodes_[i];
      if (node.count == 0)
      {
        values[i] = join(values[node.first], values[node.first + 1]);
        continue;
      }
      values[i] = ofItem(order_[node.first]);
      for (std::uint32_t k = 1; k < node.count; ++k)
      {
        values[i] = join(values[i], ofItem(order_[node.first + k]));
      }
    }
    return values;
  }

private:
  /// Of a leaf, items order_[first] and on; otherwise its two children from `first`, and count 0.
  struct Node
  {
    ItemBounds bounds;
    std::uint32_t first = 0;
    std::uint32_t count = 0;
  };
  struct Pending
  {
    double min;
    std::uint32_t node;
  };

  /// Halving 2^32 items leaves fewer on the stack.
  static constexpr int kMaxPending = 80;

  /// @param keys of the items: what they are split by.
  void split(std::uint32_t node, const std::vector<glm::dvec4>& keys, std::uint32_t first,
    std::uint32_t last);
  /// Sets the bounds of the nodes.
  void fit(const std::vector<ItemBounds>& items);

  std::vector<Node> nodes_;
  std::vector<std::uint32_t> order_;
};

} // namespace medial
