#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

namespace medial
{

/// Sorts values, and drops repeated ones.
template <typename T>
void makeSet(std::vector<T>& values)
{
  std::sort(values.begin(), values.end());
  values.erase(std::unique(values.begin(), values.end()), values.end());
}

/// Returns where a set has a value, or would have it.
template <typename T>
std::int64_t indexIn(const std::vector<T>& set, const T& value)
{
  return std::lower_bound(set.begin(), set.end(), value) - set.begin();
}

} // namespace medial
