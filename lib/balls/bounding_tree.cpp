#include "balls/bounding_tree.h"

#include <algorithm>
#include <limits>
#include <numeric>

namespace medial
{
namespace
{

constexpr std::uint32_t kLeafItems = 4;

/// Returns the keys by which items are split: their middle along x, y, z, and their reach.
std::vector<glm::dvec4> keysOf(const std::vector<ItemBounds>& items)
{
  std::vector<glm::dvec4> keys(items.size());
  for (std::size_t i = 0; i < items.size(); ++i)
  {
    keys[i] = { 0.5 * (items[i].min + items[i].max), items[i].reach };
  }
  return keys;
}

} // namespace

void ItemBounds::add(const glm::dvec3& centre, double radius)
{
  min = glm::min(min, centre);
  max = glm::max(max, centre);
  reach = std::max(reach, radius);
}

void ItemBounds::add(const ItemBounds& other)
{
  min = glm::min(min, other.min);
  max = glm::max(max, other.max);
  reach = std::max(reach, other.reach);
}

ItemBounds ItemBounds::nothing()
{
  constexpr double kFarthest = std::numeric_limits<double>::max();
  return { glm::dvec3(kFarthest), glm::dvec3(-kFarthest), 0.0 };
}

BoundingTree::BoundingTree(const std::vector<ItemBounds>& items)
  : order_(items.size())
{
  std::iota(order_.begin(), order_.end(), 0U);
  if (!items.empty())
  {
    nodes_.reserve(items.size());
    nodes_.emplace_back();
    this->split(0, keysOf(items), 0, static_cast<std::uint32_t>(items.size()));
    this->fit(items);
  }
}

void BoundingTree::split(std::uint32_t node, const std::vector<glm::dvec4>& keys,
  std::uint32_t first, std::uint32_t last)
{
  if (last - first <= kLeafItems)
  {
    nodes_[node].first = first;
    nodes_[node].count = last - first;
    return;
  }
  glm::dvec4 low = keys[order_[first]];
  glm::dvec4 high = low;
  for (std::uint32_t i = first + 1; i < last; ++i)
  {
    low = glm::min(low, keys[order_[i]]);
    high = glm::max(high, keys[order_[i]]);
  }
  int widest = 0;
  for (int key = 1; key < 4; ++key)
  {
    widest = high[key] - low[key] > high[widest] - low[widest] ? key : widest;
  }
  const std::uint32_t middle = first + (last - first) / 2;
  std::nth_element(order_.begin() + first, order_.begin() + middle, order_.begin() + last,
    [&keys, widest](std::uint32_t a, std::uint32_t b)
    {
      const double keyA = keys[a][widest];
      const double keyB = keys[b][widest];
      return keyA != keyB ? keyA < keyB : a < b;
    });
  const auto children = static_cast<std::uint32_t>(nodes_.size());
  nodes_.resize(nodes_.size() + 2);
  nodes_[node].first = children;
  this->split(children, keys, first, middle);
  this->split(children + 1, keys, middle, last);
}

void BoundingTree::fit(const std::vector<ItemBounds>& items)
{
  const auto join = [](ItemBounds a, const ItemBounds& b)
  {
    a.add(b);
    return a;
  };
  const std::vector<ItemBounds> bounds =
    this->valuesOfNodes<ItemBounds>([&items](std::uint32_t item) { return items[item]; }, join);
  for (std::size_t i = 0; i < nodes_.size(); ++i)
  {
    nodes_[i].bounds = bounds[i];
  }
}

} // namespace medial
