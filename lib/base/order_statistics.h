#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace medial
{

/// Index, in ascending order, of the largest of `count` values that has no more than a share of all
/// values before it. `count` is at least 1, the share in [0, 1).
inline std::int64_t indexAfter(double share, std::int64_t count)
{
  return static_cast<std::int64_t>(share * static_cast<double>(count));
}

/// Index, in ascending order, of the smallest of `count` values that has no more than a share of
/// all values after it.
inline std::int64_t indexBefore(double share, std::int64_t count)
{
  return count - 1 - indexAfter(share, count);
}

/// The value with an index in ascending order, in [0, number of values). Reorders the values.
template <typename T>
T valueAt(std::vector<T>& values, std::int64_t index)
{
  const auto found = values.begin() + static_cast<std::ptrdiff_t>(index);
  std::nth_element(values.begin(), found, values.end());
  return *found;
}

/// The middle one of some values in ascending order; of an even number, the larger. There must be
/// one at least. Reorders the values.
template <typename T>
T medianOf(std::vector<T>& values)
{
  return valueAt(values, static_cast<std::int64_t>(values.size() / 2));
}

} // namespace medial
