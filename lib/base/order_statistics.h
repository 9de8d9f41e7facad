#pragma once

#include <cstdint>

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

} // namespace medial
