#pragma once

#include <glm/glm.hpp>

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace medial
{

/// Bounds of an item, which is a ball or a hull of balls: centres in a box, and radii of at most
/// `reach`.
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

/// A binary tree over items, for finding those nearest to something. Items are split by the
/// position of their centres and by their size, since a large ball is near to much of space.
class BoundingTree
{
public:
  explicit BoundingTree(const std::vector<ItemBounds>& items);

  /// Calls `visit(item)` for items that may be nearer to x than `limit`, near ones first. `visit`
  /// lowers the limit when it finds something.
  template <typename Visit>
  void search(const glm::dvec3& x, double& limit, const Visit& visit) const
  {
    this->searchNodes([&](std::uint32_t node) { return nodes_[node].bounds.minDistance(x); }, limit,
      visit);
  }

  /// The same for a measure other than the distance from a point.
  /// @param minimum of a node: a lower bound of the measure of its items.
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

  /// Returns a value for every node that describes all its items.
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
  /// A leaf has the items order_[first] and following. An inner node has count 0 and two children,
  /// starting at `first`.
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

  /// Enough for halving 2^32 items.
  static constexpr int kMaxPending = 80;

  /// @param keys of the items, by which they are split.
  void split(std::uint32_t node, const std::vector<glm::dvec4>& keys, std::uint32_t first,
    std::uint32_t last);
  /// Sets the bounds of the nodes.
  void fit(const std::vector<ItemBounds>& items);

  std::vector<Node> nodes_;
  std::vector<std::uint32_t> order_;
};

} // namespace medial
