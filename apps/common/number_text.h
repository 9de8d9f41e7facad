#pragma once

#include <array>
#include <cstdio>
#include <string>

namespace medial::app
{

/// A number for people to read, with at most so many significant digits and no zeros at the end.
inline std::string asText(double number, int digits = 6)
{
  std::array<char, 48> text;
  std::snprintf(text.data(), text.size(), "%.*g", digits, number);
  return text.data();
}

} // namespace medial::app
