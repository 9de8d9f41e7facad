#pragma once

#include <filesystem>
#include <functional>

namespace medial::app
{

/// A file that appears only when it is complete. It is written under a temporary name in the same
/// folder; commit() gives it its name, in place of an older file. Without commit() nothing is left.
class OutputFile
{
public:
  /// Checks that a file can be made there; leaves nothing behind.
  /// @throws Failure NoSpace when the folder does not exist or refuses it, or when `path` exists
  ///   and is no regular file.
  explicit OutputFile(const std::filesystem::path& path);
  ~OutputFile();
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  /// The name that the user gave.
  const std::filesystem::path& path() const { return path_; }

  /// Makes the temporary file, empty, and returns its name.
  const std::filesystem::path& open();

  /// @throws Failure NoSpace.
  void commit();

private:
  std::filesystem::path path_;
  std::filesystem::path target_; // path_ with its symbolic links followed
  std::filesystem::path temporary_;
};

/// Runs work that writes a file and names the file in the message of what it throws for want of
/// space.
void namingFile(const std::filesystem::path& path, const std::function<void()>& work);

} // namespace medial::app
