#pragma once

#include <string>

namespace medial
{

///@{
/// Reports what is wrong with the content of a file; readFile() adds the name of the file. Of the
/// message 300 characters are kept, and those that are not printable become question marks.
/// @param line where the mistake is, from 1; 0 if that is unknown.
/// @throws Error InvalidInput.
[[noreturn]] void refuse(const std::string& why);
[[noreturn]] void refuseLine(int line, const std::string& why);
///@}

} // namespace medial
