#include "files/file_content.h"

#include <algorithm>
#include <cctype>
#include <cstdint>
#include <fstream>

namespace fs = std::filesystem;

namespace medial::files
{
namespace
{

[[noreturn]] void refuseFile(const fs::path& path, const std::string& why)
{
  throw Error(ErrorCode::CannotRead, path.string() + ": " + why);
}

} // namespace

std::string extensionOf(const fs::path& path)
{
  std::string extension = path.extension().string();
  if (extension == ".gz" || extension == ".GZ")
  {
    extension = path.stem().extension().string() + extension;
  }
  std::transform(extension.begin(), extension.end(), extension.begin(),
    [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return extension;
}

void refuseContent(std::string why)
{
  constexpr std::size_t kMaxLength = 300;
  if (why.size() > kMaxLength)
  {
    why.replace(kMaxLength, std::string::npos, "...");
  }
  std::replace_if(
    why.begin(), why.end(), [](char c) { return c < ' ' || c > '~'; }, '?');
  throw Error(ErrorCode::InvalidInput, why);
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

std::string readContent(const fs::path& path)
{
  requireRegularFile(path);
  std::error_code error;
  const std::uintmax_t size = fs::file_size(path, error);
  std::string content = withName(path, [&] { return std::string(error ? 0 : size, '\0'); });
  std::ifstream file(path, std::ios::binary);
  file.read(content.data(), static_cast<std::streamsize>(content.size()));
  if (error || !file)
  {
    refuseFile(path, "cannot be read");
  }
  if (content.empty())
  {
    throw Error(ErrorCode::InvalidInput, path.string() + ": the file is empty");
  }
  return content;
}

} // namespace medial::files
