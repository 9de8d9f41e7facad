#pragma once

#include <filesystem>
#include <functional>
#include <string>

namespace medial::app
{

/// A file that appears only when it is complete. It is written under a temporary name in the same
/// folder; commit() renames it and replaces an older file. Without commit() nothing is left.
class OutputFile
{
public:
  /// Checks that a file can be created there; leaves nothing behind.
  /// @throws Failure NoSpace if the folder does not exist or refuses new files, or if `path` exists
  ///   and is not a regular file.
  explicit OutputFile(const std::filesystem::path& path);
  ~OutputFile();
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  /// The name that the user gave.
  const std::filesystem::path& path() const { return path_; }

  /// Creates the temporary file, empty, and returns its name.
  std::filesystem::path open();

  /// @throws Failure NoSpace.
  void commit();

  /// Removes the temporary files of all objects, and keeps other threads from making more: for
  /// programs that are about to end without destroying them. Allocates nothing.
  static void removeTemporaries() noexcept;

private:
  void create();
  void discard();
  void forget();

  std::filesystem::path path_;
  std::filesystem::path target_;   // path_ with its symbolic links followed
  std::string temporary_;          // empty while there is none
  OutputFile* previous_ = nullptr; // with a temporary file
};

/// Runs work that writes a file. Where the work throws Failure NoSpace, adds the name of the file
/// to the message.
void namingFile(const std::filesystem::path& path, const std::function<void()>& work);

} // namespace medial::app
