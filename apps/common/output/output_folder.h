#pragma once

#include <filesystem>

namespace medial::app
{

/// A folder for outputs. It is made if there is none, and removed again unless commit() is called
/// or something else has put files into it.
class OutputFolder
{
public:
  /// @throws Failure NoSpace if the folder cannot be made, or if `path` exists and is no folder.
  explicit OutputFolder(const std::filesystem::path& path);
  ~OutputFolder();
  OutputFolder(const OutputFolder&) = delete;
  OutputFolder& operator=(const OutputFolder&) = delete;

  /// Keeps the folder.
  void commit() { made_ = false; }

private:
  std::filesystem::path path_;
  bool made_ = false; // and not yet committed
};

} // namespace medial::app
