#pragma once

#include <CLI/CLI.hpp>

#include <charconv>
#include <cstddef>
#include <map>
#include <string>
#include <system_error>
#include <type_traits>
#include <vector>

namespace medial::app
{

/// Accepts the words only; the message lists them.
CLI::Validator oneOf(const std::vector<std::string>& words);

template <typename T>
CLI::Validator oneOf(const std::map<std::string, T>& names)
{
  std::vector<std::string> words;
  for (const auto& name : names)
  {
    words.push_back(name.first);
  }
  return oneOf(words);
}

/// Whether a word is a whole number that T cannot hold.
template <typename T>
bool isTooLarge(const std::string& word)
{
  T value{};
  const std::size_t sign = word.size() > 1 && word.front() == '+' ? 1 : 0;
  return std::from_chars(word.data() + sign, word.data() + word.size(), value).ec ==
    std::errc::result_out_of_range;
}

/// Accepts numbers for which `inside` holds; the message gives the value and `interval`.
template <typename T>
CLI::Validator within(const std::string& interval, bool (*inside)(T))
{
  return CLI::Validator(
    [interval, inside](std::string& word)
    {
      if constexpr (std::is_integral_v<T>)
      {
        if (isTooLarge<T>(word))
        {
          return word + " is outside " + interval;
        }
      }
      T value{};
      const bool known = CLI::detail::lexical_cast(word, value);
      if (!known)
      {
        return word + (std::is_integral_v<T> ? " is not a whole number" : " is not a number") +
          "; allowed: " + interval;
      }
      return inside(value) ? std::string() : word + " is outside " + interval;
    },
    "");
}

} // namespace medial::app
