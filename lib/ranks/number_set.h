#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

namespace medial
{

/// Sorts numbers, and drops repeated ones.
inline void makeSet(std::vector<int>& numbers)
{
  std::sort(numbers.begin(), numbers.end());
  numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
}

/// Returns where a set has a number, or would have it.
inline std::int64_t indexIn(const std::vector<int>& set, int number)
{
  return std::lower_bound(set.begin(), set.end(), number) - set.begin();
}

} // namespace medial
