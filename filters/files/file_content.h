#pragma once

#include "medial/error.h"

#include <filesystem>
#include <new>
#include <string>

// Files that are read as a whole.
namespace medial::files
{

/// The extension in lower case, with its dot; in front of .gz, the one before as well.
std::string extensionOf(const std::filesystem::path& path);

/// Reports what is wrong with the content of a file; withName() adds the name of the file. Of the
/// message 300 characters are kept, and those that are not printable become question marks.
/// @throws Error InvalidInput.
[[noreturn]] void refuseContent(std::string why);

/// @throws Error CannotRead naming the file if it does not exist, or cannot be read from start to
///   end.
void requireRegularFile(const std::filesystem::path& path);

/// The whole content of a file.
/// @throws Error naming the file: CannotRead, InvalidInput if it is empty, OutOfMemory if it does
///   not fit into memory.
std::string readContent(const std::filesystem::path& path);

/// Returns what `work` returns, and puts the name of a file in front of the message of its errors.
/// @throws Error as `work`, and OutOfMemory in place of std::bad_alloc.
template <typename Work>
auto withName(const std::filesystem::path& path, const Work& work)
{
  try
  {
    return work();
  }
  catch (const Error& error)
  {
    throw Error(error.code(), path.string() + ": " + error.what());
  }
  catch (const std::bad_alloc&)
  {
    throw Error(ErrorCode::OutOfMemory, path.string() + ": not enough memory");
  }
}

} // namespace medial::files
