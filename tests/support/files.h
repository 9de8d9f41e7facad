#pragma once

#include <filesystem>
#include <string>
#include <vector>

// Files that tests write and read.
namespace medial::test
{

/// A folder of its own that is removed with all its content at the end.
class TemporaryFolder
{
public:
  TemporaryFolder();
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }
  std::string file(const std::string& name) const { return (path_ / name).string(); }
  /// Names of the files in it, hidden ones too, in order.
  std::vector<std::string> list() const;

private:
  std::filesystem::path path_;
};

void writeFile(const std::string& path, const std::string& content);
std::string readFile(const std::string& path);

bool contains(const std::string& text, const std::string& part);

} // namespace medial::test
