#pragma once

#include <CLI/CLI.hpp>

#include <map>
#include <string>

namespace medial::app
{

/// The words that an option takes, with their values.
using Names = std::map<std::string, int>;

/// Accepts the names only; the message lists them.
CLI::Validator oneOf(const Names& names);

/// Accepts numbers for which `inside` holds; the message gives the value and `interval`.
template <typename T>
CLI::Validator within(const std::string& interval, bool (*inside)(T))
{
  return CLI::Validator(
    [interval, inside](std::string& word)
    {
      T value{};
      const bool known = CLI::detail::lexical_cast(word, value);
      return known && inside(value) ? std::string() : word + " is outside " + interval;
    },
    "");
}

} // namespace medial::app
