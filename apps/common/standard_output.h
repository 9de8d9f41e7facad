#pragma once

#include <filesystem>
#include <string>

namespace medial::app
{

/// What stands for standard output where a file's name is expected.
inline const std::filesystem::path kStandardOutput = "-";

/// Prints text on standard output.
/// @throws Failure NoSpace unless all of it was written.
void printText(const std::string& text);

} // namespace medial::app
