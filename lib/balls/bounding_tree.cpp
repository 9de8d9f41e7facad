#include "balls/bounding_tree.h"

#include <algorithm>
#include <limits>
#include <numeric>

namespace medial
{
namespace
{

constexpr std::uint32_t kLeafItems = 4;

/// Middle of an item along x, y, z, or its reach.
double keyOf(const ItemBounds& item, int key)
{
  return key < 3 ? 0.5 * (item.min[key] + item.max[key]) : item.reach;
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
    this->split(0, items, 0, static_cast<std::uint32_t>(items.size()));
  }
}

void BoundingTree::split(std::uint32_t node, const std::vector<ItemBounds>& items,
  std::uint32_t first, std::uint32_t last)
{
  ItemBounds bounds = ItemBounds::nothing();
  double low[4];
  double high[4];
  for (int key = 0; key < 4; ++key)
  {
    low[key] = high[key] = keyOf(items[order_[first]], key);
  }
  for (std::uint32_t i = first; i < last; ++i)
  {
    const ItemBounds& item = items[order_[i]];
    bounds.add(item);
    for (int key = 0; key < 4; ++key)
    {
      low[key] = std::min(low[key], keyOf(item, key));
      high[key] = std::max(high[key], keyOf(item, key));
    }
  }
  nodes_[node].bounds = bounds;
  if (last - first <= kLeafItems)
  {
    nodes_[node].first = first;
    nodes_[node].count = last - first;
    return;
  }
  int widest = 0;
  for (int key = 1; key < 4; ++key)
  {
    widest = high[key] - low[key] > high[widest] - low[widest] ? key : widest;
  }
  const std::uint32_t middle = first + (last - first) / 2;
  std::nth_element(order_.begin() + first, order_.begin() + middle, order_.begin() + last,
    [&items, widest](std::uint32_t a, std::uint32_t b)
    {
      const double keyA = keyOf(items[a], widest);
      const double keyB = keyOf(items[b], widest);
      return keyA != keyB ? keyA < keyB : a < b;
    });
  const auto children = static_cast<std::uint32_t>(nodes_.size());
  nodes_.resize(nodes_.size() + 2);
  nodes_[node].first = children;
  this->split(children, items, first, middle);
  this->split(children + 1, items, middle, last);
}

} // namespace medial
