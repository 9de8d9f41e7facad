#pragma once

#include "ranks/collective.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

// Sorting what several ranks have.
namespace medial
{

/// Shares numbers out evenly, if they are.
class Buckets
{
public:
  /// @param largest of this rank; -1 for none.
  Buckets(Communicator& communicator, std::int64_t largest)
    : size_(maximum(communicator, largest) / communicator.size() + 1)
  {
  }

  int of(std::int64_t number) const { return static_cast<int>(number / size_); }

private:
  std::int64_t size_;
};

/// The indices of the items of lists, one list after the other, sorted.
template <typename Item, typename Less>
std::vector<std::pair<int, int>> sortedItems(const RankLists<Item>& lists, const Less& less)
{
  std::vector<std::pair<int, int>> order;
  for (std::size_t rank = 0; rank < lists.size(); ++rank)
  {
    for (std::size_t i = 0; i < lists[rank].size(); ++i)
    {
      order.emplace_back(static_cast<int>(rank), static_cast<int>(i));
    }
  }
  std::sort(order.begin(), order.end(),
    [&](const auto& a, const auto& b)
    {
      const Item& x = lists[a.first][a.second];
      const Item& y = lists[b.first][b.second];
      return less(x, y) || (!less(y, x) && a < b);
    });
  return order;
}

/// Returns lists of numbers as long as others.
template <typename Item>
RankLists<int> numbersFor(const RankLists<Item>& lists)
{
  RankLists<int> numbers(lists.size());
  for (std::size_t rank = 0; rank < lists.size(); ++rank)
  {
    numbers[rank].resize(lists[rank].size());
  }
  return numbers;
}

/// Returns the largest of some numbers, none of which is negative; -1 for none.
inline std::int64_t largestOf(const std::vector<std::int64_t>& numbers)
{
  return numbers.empty() ? -1 : *std::max_element(numbers.begin(), numbers.end());
}

} // namespace medial
