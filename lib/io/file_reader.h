#pragma once

#include "medial/error.h"

#include <filesystem>
#include <string>

namespace medial
{

/// The whole content of a file.
/// @throws Error CannotRead without the file's name.
std::string readContent(const std::filesystem::path& path);

/// The extension in lower case, with its dot.
std::string extensionOf(const std::filesystem::path& path);

/// @throws Error CannotRead without the file's name when there is no such file, or none that can be
///   read from start to end.
void requireRegularFile(const std::filesystem::path& path);

/// Returns what `read` makes of a file; the errors that it throws get the file's name.
/// @throws Error as `read`, and CannotRead.
template <typename Read>
auto readFile(const std::filesystem::path& path, const Read& read)
{
  try
  {
    requireRegularFile(path);
    return read(path);
  }
  catch (const Error& error)
  {
    throw Error(error.code(), path.string() + ": " + error.what());
  }
  catch (const std::filesystem::filesystem_error& error)
  {
    throw Error(ErrorCode::CannotRead, path.string() + ": " + error.code().message());
  }
}

} // namespace medial
