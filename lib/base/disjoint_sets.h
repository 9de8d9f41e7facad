#pragma once

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <vector>

namespace medial
{

/// Union-find over the elements 0 .. count - 1.
class DisjointSets
{
public:
  explicit DisjointSets(std::size_t count = 0)
    : parent_(count)
  {
    this->separate();
  }

  /// Every element becomes a set of its own; memory is kept.
  void reset(std::size_t count)
  {
    parent_.resize(count);
    this->separate();
  }

  std::int64_t size() const { return static_cast<std::int64_t>(parent_.size()); }

  /// Returns the lowest member of an element's set.
  std::int64_t find(std::int64_t element)
  {
    while (parent_[element] != element)
    {
      parent_[element] = parent_[parent_[element]];
      element = parent_[element];
    }
    return element;
  }

  /// Joins the sets of two elements. Returns whether they were different.
  bool join(std::int64_t a, std::int64_t b)
  {
    a = this->find(a);
    b = this->find(b);
    parent_[std::max(a, b)] = std::min(a, b);
    return a != b;
  }

private:
  void separate() { std::iota(parent_.begin(), parent_.end(), std::int64_t{ 0 }); }

  std::vector<std::int64_t> parent_;
};

/// The number of pieces that pairs of ids in [0, points) leave.
template <typename Pairs>
std::int64_t countComponents(std::size_t points, const Pairs& pairs)
{
  DisjointSets sets(points);
  std::int64_t count = sets.size();
  for (const auto& [a, b] : pairs)
  {
    count -= sets.join(a, b) ? 1 : 0;
  }
  return count;
}

} // namespace medial
