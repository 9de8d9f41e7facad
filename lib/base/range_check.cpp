#include "base/range_check.h"

#include <array>
#include <charconv>
#include <cmath>

namespace medial
{
namespace
{

template <typename T>
std::string spelled(T number)
{
  std::array<char, 32> text;
  return { text.data(), std::to_chars(text.data(), text.data() + text.size(), number).ptr };
}

} // namespace

// The sign of a NaN means nothing.
std::string numberText(double number)
{
  return std::isnan(number) ? "nan" : spelled(number);
}

std::string numberText(float number)
{
  return std::isnan(number) ? "nan" : spelled(number);
}

std::string numberText(std::int64_t number)
{
  return spelled(number);
}

std::string numberText(int number)
{
  return spelled(number);
}

} // namespace medial
