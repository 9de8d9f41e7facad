#include "input_file.h"

#include "failure.h"

#include <algorithm>
#include <cctype>

namespace fs = std::filesystem;

namespace medial::app
{

std::string extensionOf(const fs::path& path)
{
  std::string extension = path.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
    [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return extension;
}

void refuseFile(const fs::path& path, const std::string& why)
{
  throw Failure(ExitCode::BadInput, path.string() + ": " + why);
}

void requireRegularFile(const fs::path& path)
{
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (fs::is_regular_file(status))
  {
    return;
  }
  if (status.type() == fs::file_type::not_found)
  {
    refuseFile(path, "no such file");
  }
  refuseFile(path, error ? error.message() : "is not a regular file");
}

} // namespace medial::app
