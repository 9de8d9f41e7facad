#include "base/hilbert_curve.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace medial
{
namespace
{

constexpr int kBits = 20; ///< of a coordinate

/// Puts two zeros between all bits of a number.
std::uint64_t spread(std::uint64_t bits)
{
  bits = (bits | bits << 32) & 0x001f00000000ffff;
  bits = (bits | bits << 16) & 0x001f0000ff0000ff;
  bits = (bits | bits << 8) & 0x100f00f00f00f00f;
  bits = (bits | bits << 4) & 0x10c30c30c30c30c3;
  return (bits | bits << 2) & 0x1249249249249249;
}

/// Returns for every bit whether an odd number of those above it is set.
std::uint32_t oddAbove(std::uint32_t bits)
{
  std::uint32_t odd = bits >> 1;
  for (int shift = 1; shift < kBits; shift *= 2)
  {
    odd ^= odd >> shift;
  }
  return odd;
}

/// Returns the place of a cell (Skilling 2004), without branches: no processor could guess them.
std::uint64_t hilbertCode(std::array<std::uint32_t, 3> x)
{
  for (int bit = kBits - 1; bit > 0; --bit)
  {
    const std::uint32_t below = (1u << bit) - 1u;
    for (std::uint32_t& coordinate : x)
    {
      const std::uint32_t set = 0u - (coordinate >> bit & 1u);
      const std::uint32_t exchanged = (x[0] ^ coordinate) & below & ~set;
      x[0] ^= (below & set) | exchanged;
      coordinate ^= exchanged; // 0 for x[0] itself
    }
  }
  x[1] ^= x[0];
  x[2] ^= x[1];
  const std::uint32_t turned = oddAbove(x[2]);
  return spread(x[0] ^ turned) << 2 | spread(x[1] ^ turned) << 1 | spread(x[2] ^ turned);
}

} // namespace

HilbertCurve::HilbertCurve(const glm::dvec3& low, const glm::dvec3& high)
  : low_(low)
{
  const glm::dvec3 size = high - low;
  const double longest = std::max({ size.x, size.y, size.z });
  scale_ = longest > 0.0 ? std::exp2(kBits) / longest : 0.0;
}

std::uint64_t HilbertCurve::placeOf(const glm::dvec3& x) const
{
  const glm::dvec3 cell = glm::clamp((x - low_) * scale_, 0.0, std::exp2(kBits) - 1.0);
  return hilbertCode({ static_cast<std::uint32_t>(cell.x), static_cast<std::uint32_t>(cell.y),
    static_cast<std::uint32_t>(cell.z) });
}

} // namespace medial
