#pragma once

#include <filesystem>
#include <string>

namespace medial::app
{

/// The extension in lower case, with its dot.
std::string extensionOf(const std::filesystem::path& path);

/// Reports what is wrong with an input file.
/// @throws Failure BadInput naming the file.
[[noreturn]] void refuseFile(const std::filesystem::path& path, const std::string& why);

/// @throws Failure BadInput naming the file if it does not exist or cannot be read from start to
///   end.
void requireRegularFile(const std::filesystem::path& path);

} // namespace medial::app
