#include "length.h"

#include <CLI/CLI.hpp>

#include <cmath>

namespace medial::app
{

std::optional<Length> parseLength(const std::string& word)
{
  Length length;
  length.percent = !word.empty() && word.back() == '%';
  const std::string number = length.percent ? word.substr(0, word.size() - 1) : word;
  if (!CLI::detail::lexical_cast(number, length.value) || !std::isfinite(length.value) ||
    length.value < 0.0)
  {
    return std::nullopt;
  }
  return length;
}

} // namespace medial::app
