#pragma once

#include "medial/grid.h"

#include <cstdint>
#include <cstring>

namespace medial
{

/// Returns a hash of the bits of a position, and of what has been hashed before.
inline std::uint64_t hashOf(const Point3& position, std::uint64_t before = 0)
{
  std::uint64_t result = before;
  for (const double coordinate : position)
  {
    std::uint64_t bits = 0;
    std::memcpy(&bits, &coordinate, sizeof(bits));
    result = (result ^ bits) * 0x9e3779b97f4a7c15u;
    result ^= result >> 32;
  }
  return result;
}

} // namespace medial
