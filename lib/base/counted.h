#pragma once

#include <cstdint>
#include <string>

namespace medial
{

/// Returns a number and what it counts, which takes an s unless it is 1.
inline std::string counted(std::int64_t number, const std::string& what)
{
  return std::to_string(number) + " " + what + (number == 1 ? "" : "s");
}

} // namespace medial
