#pragma once

#include "medial/grid.h"

#include <array>
#include <charconv>
#include <cstdio>
#include <string>

namespace medial::app
{

/// The shortest text that reads back without loss, in every locale.
inline std::string numberText(double number)
{
  std::array<char, 32> text;
  return { text.data(), std::to_chars(text.data(), text.data() + text.size(), number).ptr };
}

/// The coordinates with blanks between them.
inline std::string pointText(const Point3& point)
{
  return numberText(point[0]) + ' ' + numberText(point[1]) + ' ' + numberText(point[2]);
}

/// For people: at most so many significant digits, and no zeros at the end.
inline std::string roundedText(double number, int digits = 6)
{
  std::array<char, 48> text;
  std::snprintf(text.data(), text.size(), "%.*g", digits, number);
  return text.data();
}

} // namespace medial::app
