#pragma once

#include <cstdint>
#include <cstring>

namespace medial::test
{

/// Whether two values are the same, or both the same NaN.
inline bool sameBits(float a, float b)
{
  std::uint32_t bits[2];
  std::memcpy(&bits[0], &a, sizeof(a));
  std::memcpy(&bits[1], &b, sizeof(b));
  return bits[0] == bits[1];
}

} // namespace medial::test
