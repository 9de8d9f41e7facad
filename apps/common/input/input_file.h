#pragma once

#include "files/file_content.h"

#include <filesystem>
#include <functional>
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

/// Runs `work`, which reads a file, and turns its errors, and those that VTK reports, into
/// failures.
/// @param path the file, for messages of VTK; errors that `work` throws name it themselves.
/// @throws Failure BadInput naming the file; NoSpace if it does not fit into memory.
void withReaderFailures(const std::filesystem::path& path, const std::function<void()>& work);

} // namespace medial::app
