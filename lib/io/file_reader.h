#pragma once

#include "medial/error.h"

#include <filesystem>
#include <new>
#include <string>

namespace medial
{

/// Returns the whole content of a file.
/// @throws Error CannotRead, without the name of the file.
std::string readContent(const std::filesystem::path& path);

/// Returns the extension in lower case, with its dot.
std::string extensionOf(const std::filesystem::path& path);

/// Checks that a path leads to a file that can be read from start to end.
/// @throws Error CannotRead, without the name of the file.
void requireRegularFile(const std::filesystem::path& path);

/// Returns the result of `read` for a file, and adds the name of the file to its errors.
/// @throws Error as `read`, CannotRead, and OutOfMemory if the content does not fit into memory.
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
  catch (const std::bad_alloc&)
  {
    throw Error(ErrorCode::OutOfMemory, path.string() + ": not enough memory");
  }
}

} // namespace medial
