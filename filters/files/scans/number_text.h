#pragma once

#include <locale>
#include <sstream>
#include <string>

namespace medial::files
{

/// A number with at most some significant digits, in every locale with a point.
inline std::string roundedText(double number, int digits = 6)
{
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text.precision(digits);
  text << number;
  return text.str();
}

} // namespace medial::files
