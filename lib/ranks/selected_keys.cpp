#include "ranks/selected_keys.h"

#include <cstring>
#include <functional>

namespace medial
{
namespace
{

constexpr std::uint32_t kSign = 0x80000000u;
constexpr int kDigitBits = 8;
constexpr int kDigits = 1 << kDigitBits;

} // namespace

std::uint32_t ascending(float value)
{
  std::uint32_t bits = 0;
  const float positiveZero = value + 0.0f;
  std::memcpy(&bits, &positiveZero, sizeof(bits));
  return (bits & kSign) != 0 ? ~bits : bits | kSign;
}

float valueOf(std::uint32_t number)
{
  const std::uint32_t bits = (number & kSign) != 0 ? number & ~kSign : ~number;
  float value = 0.0f;
  std::memcpy(&value, &bits, sizeof(value));
  return value;
}

std::vector<std::uint64_t> keysAt(Communicator& communicator, const std::vector<ListedKey>& keys,
  std::vector<std::int64_t> indices)
{
  std::vector<std::uint64_t> found(indices.size(), 0);
  for (int shift = 64 - kDigitBits; shift >= 0; shift -= kDigitBits)
  {
    std::vector<std::int64_t> counts(indices.size() * kDigits, 0);
    for (const ListedKey& key : keys)
    {
      // What is above the digit must be as found so far; for the first digit nothing is.
      const int above = shift + kDigitBits;
      if (above == 64 || key.key >> above == found[key.list] >> above)
      {
        ++counts[key.list * kDigits + (key.key >> shift & (kDigits - 1))];
      }
    }
    counts = combined(communicator, counts, std::plus<>());
    for (std::size_t list = 0; list < indices.size(); ++list)
    {
      std::uint64_t digit = 0;
      while (indices[list] >= counts[list * kDigits + digit])
      {
        indices[list] -= counts[list * kDigits + digit];
        ++digit;
      }
      found[list] |= digit << shift;
    }
  }
  return found;
}

} // namespace medial
