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

/// Sees to it that what was printed on standard output has reached it.
/// @throws Failure NoSpace unless all of it was written.
void flushStandardOutput();

/// Prints the line of a summary that names a file which was written, and what it holds; nothing
/// without a path.
void printFile(const std::filesystem::path& path, const std::string& content);

} // namespace medial::app
