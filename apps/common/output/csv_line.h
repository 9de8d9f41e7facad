#pragma once

#include "medial/grid.h"

#include <array>
#include <charconv>
#include <string>

namespace medial::app
{

/// A line of a table: numbers in the shortest spelling that is read back without loss, and words.
class CsvLine
{
public:
  template <typename Number>
  CsvLine& operator<<(Number number)
  {
    std::array<char, 32> text;
    const auto [end, error] = std::to_chars(text.begin(), text.end(), number);
    text_.append(text_.empty() ? "" : ",").append(text.begin(), end);
    return *this;
  }
  CsvLine& operator<<(const char* word)
  {
    text_.append(text_.empty() ? "" : ",").append(word);
    return *this;
  }
  CsvLine& operator<<(const Point3& point) { return *this << point[0] << point[1] << point[2]; }

  /// Ends the line and returns it.
  const std::string& end()
  {
    text_ += '\n';
    return text_;
  }

private:
  std::string text_;
};

} // namespace medial::app
