#pragma once

#include "medial/error.h"

#include <cstdint>
#include <string>

namespace medial
{

///@{
/// Returns the shortest text that is read back as the same number, in every locale. With fewer
/// digits, a value outside a range could read as if it were inside.
std::string numberText(double number);
std::string numberText(float number);
std::string numberText(std::int64_t number);
std::string numberText(int number);
///@}

/// Returns the text of a range that includes both ends.
template <typename T>
std::string closedRange(T low, T high)
{
  return '[' + numberText(low) + ", " + numberText(high) + ']';
}

/// Says that a value is outside its range.
/// @param name of the value.
/// @param range the allowed values, such as "(0, 180) degrees".
template <typename T>
std::string outsideText(const std::string& name, T value, const std::string& range)
{
  return name + ' ' + numberText(value) + " is outside " + range;
}

/// Refuses a parameter that is outside its range, see outsideText().
/// @throws Error InvalidInput with the name, the value and the range.
template <typename T>
[[noreturn]] void throwOutside(const std::string& name, T value, const std::string& range)
{
  throw Error(ErrorCode::InvalidInput, outsideText(name, value, range));
}

} // namespace medial
