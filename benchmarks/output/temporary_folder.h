#pragma once

#include <filesystem>
#include <stdexcept>
#include <string>

#include <stdlib.h> // NOLINT: mkdtemp is POSIX's

namespace medial::benchmark
{

/// A folder that is removed with its contents at the end.
class TemporaryFolder
{
public:
  /// @throws std::runtime_error if it cannot be created.
  TemporaryFolder()
  {
    std::string pattern = (std::filesystem::temp_directory_path() / "medial-XXXXXX").string();
    if (!mkdtemp(pattern.data()))
    {
      throw std::runtime_error("cannot make the temporary folder " + pattern);
    }
    path_ = pattern;
  }
  ~TemporaryFolder()
  {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }

private:
  std::filesystem::path path_;
};

} // namespace medial::benchmark
