#pragma once

#include "files/file_content.h"

#include <filesystem>
#include <string>

namespace medial::app
{

using files::extensionOf;
using files::refuseContent;

/// The name of the file without folder and extension.
std::string stemOf(const std::filesystem::path& path);

/// Reports what is wrong with an input file.
/// @throws Failure BadInput naming the file.
[[noreturn]] void refuseFile(const std::filesystem::path& path, const std::string& why);

///@{
/// As in `files`.
/// @throws Failure BadInput naming the file; NoSpace if it does not fit into memory.
void requireRegularFile(const std::filesystem::path& path);
std::string readContent(const std::filesystem::path& path);
///@}

} // namespace medial::app
