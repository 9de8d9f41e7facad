#include "files/encoded_bytes.h"

#include "files/file_content.h"

#include <algorithm>
#include <array>
#include <cstdint>

namespace medial::files
{
namespace
{

constexpr int kNoDigit = -1;

int digitOf(char character)
{
  static const auto kDigits = []
  {
    std::array<int, 256> digits{};
    digits.fill(kNoDigit);
    int value = 0;
    for (const char digit :
      std::string_view("ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/"))
    {
      digits[static_cast<unsigned char>(digit)] = value++;
    }
    return digits;
  }();
  return kDigits[static_cast<unsigned char>(character)];
}

// The first `count` bytes of base64 that is long enough.
std::string decodeBase64(std::string_view text, std::size_t count)
{
  std::string bytes;
  bytes.reserve(count);
  std::uint32_t bits = 0;
  int known = 0;
  for (std::size_t i = 0; bytes.size() < count; ++i)
  {
    const int digit = digitOf(text[i]);
    if (digit == kNoDigit)
    {
      refuseContent("an array ends early or is not in base64");
    }
    bits = bits << 6 | static_cast<std::uint32_t>(digit);
    known += 6;
    if (known >= 8)
    {
      known -= 8;
      bytes += static_cast<char>(bits >> known & 0xFF);
    }
  }
  return bytes;
}

} // namespace

EncodedBytes::EncodedBytes(std::string_view text, bool base64)
  : text_(text)
  , base64_(base64)
{
  if (base64_)
  {
    text_.remove_prefix(std::min(text_.find_first_not_of(" \t\r\n"), text_.size()));
  }
}

std::string EncodedBytes::peek(std::size_t count) const
{
  if (count > this->size())
  {
    refuseContent("an array ends early: it asks for " + std::to_string(count) +
      " bytes where at most " + std::to_string(this->size()) + " are left");
  }
  return base64_ ? decodeBase64(text_, count) : std::string(text_.substr(0, count));
}

std::string EncodedBytes::take(std::size_t count)
{
  std::string bytes = this->peek(count);
  text_.remove_prefix(base64_ ? (count + 2) / 3 * 4 : count);
  return bytes;
}

} // namespace medial::files
