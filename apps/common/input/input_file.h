#pragma once

#include <filesystem>
#include <string>

namespace medial::app
{

/// The extension in lower case, with its dot; in front of .gz, the one before as well.
std::string extensionOf(const std::filesystem::path& path);

/// The name of the file without folder and extension.
std::string stemOf(const std::filesystem::path& path);

/// Reports what is wrong with an input file.
/// @throws Failure BadInput naming the file.
[[noreturn]] void refuseFile(const std::filesystem::path& path, const std::string& why);

/// Reports what is wrong with the content of a file; withFailures() adds the name of the file. Of
/// the message 300 characters are kept, and those that are not printable become question marks.
/// @throws Error InvalidInput.
[[noreturn]] void refuseContent(std::string why);

/// @throws Failure BadInput naming the file if it does not exist or cannot be read from start to
///   end.
void requireRegularFile(const std::filesystem::path& path);

/// The whole content of a file.
/// @throws Failure as requireRegularFile(); NoSpace naming the file if it does not fit into memory.
std::string readContent(const std::filesystem::path& path);

} // namespace medial::app
