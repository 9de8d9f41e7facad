#pragma once

#include "output/output_file.h"

#include <filesystem>
#include <functional>
#include <list>

namespace medial::app
{

/// Files that appear together when all of them are complete, or not at all.
class OutputFiles
{
public:
  /// Checks that a file can be created there; leaves nothing behind. Does nothing for an empty
  /// path, and for kStandardOutput.
  /// @throws Failure NoSpace.
  void add(const std::filesystem::path& path);

  /// Calls `write` to create one of the files under a temporary name; does nothing for a path that
  /// was not added.
  /// @throws Failure of `write`, naming the file if it could not be written, and Interrupted.
  void write(const std::filesystem::path& path,
    const std::function<void(const std::filesystem::path& file)>& write);

  /// Gives all files their names.
  /// @throws Failure NoSpace or Interrupted.
  void commit();

private:
  std::list<OutputFile> files_;
};

} // namespace medial::app
