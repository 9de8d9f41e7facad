#include "base/hilbert_curve.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace medial
{
namespace
{

constexpr int kBits = 20; ///< of a coordinate

/// Returns the place of a cell (Skilling 2004).
std::uint64_t hilbertCode(std::array<std::uint32_t, 3> x)
{
  constexpr std::uint32_t kTop = 1u << (kBits - 1);
  for (std::uint32_t q = kTop; q > 1; q >>= 1)
  {
    const std::uint32_t p = q - 1;
    for (std::uint32_t& coordinate : x)
    {
      if ((coordinate & q) != 0)
      {
        x[0] ^= p;
      }
      else
      {
        const std::uint32_t t = (x[0] ^ coordinate) & p;
        x[0] ^= t;
        coordinate ^= t;
      }
    }
  }
  x[1] ^= x[0];
  x[2] ^= x[1];
  std::uint32_t t = 0;
  for (std::uint32_t q = kTop; q > 1; q >>= 1)
  {
    t ^= (x[2] & q) != 0 ? q - 1 : 0;
  }
  std::uint64_t code = 0;
  for (int bit = kBits - 1; bit >= 0; --bit)
  {
    for (const std::uint32_t coordinate : x)
    {
      code = code << 1 | (((coordinate ^ t) >> bit) & 1u);
    }
  }
  return code;
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
