#pragma once

#include <charconv>
#include <optional>
#include <string_view>
#include <system_error>

namespace medial::files
{

/// The number that a whole word spells, in every locale; a plus may stand in front. "nan" and "inf"
/// are floating-point numbers. Nothing where the word has anything else, or T cannot hold the
/// number.
template <typename T>
std::optional<T> parsedNumber(std::string_view word)
{
  if (word.size() > 1 && word[0] == '+' && word[1] != '-')
  {
    word.remove_prefix(1);
  }
  T value{};
  const char* const end = word.data() + word.size();
  const auto [stop, error] = std::from_chars(word.data(), end, value);
  return error == std::errc() && stop == end ? std::optional(value) : std::nullopt;
}

} // namespace medial::files
