#pragma once

#include <string>

namespace medial
{

///@{
/// Says what is wrong with the content of a file; readFile() adds the file's name.
/// @param line where it is wrong, from 1; 0 where that is unknown.
/// @throws Error InvalidInput.
[[noreturn]] void refuse(const std::string& why);
[[noreturn]] void refuseLine(int line, const std::string& why);
///@}

} // namespace medial
