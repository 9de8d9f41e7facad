#include "io/file_reader.h"

#include "io/text_cursor.h"

#include <fstream>

namespace fs = std::filesystem;

namespace medial
{

std::string readContent(const fs::path& path)
{
  std::ifstream file(path, std::ios::binary);
  std::string content(fs::file_size(path), '\0');
  file.read(content.data(), static_cast<std::streamsize>(content.size()));
  if (!file)
  {
    throw Error(ErrorCode::CannotRead, "cannot be read");
  }
  return content;
}

std::string extensionOf(const fs::path& path)
{
  return lowerCase(path.extension().string());
}

void requireRegularFile(const fs::path& path)
{
  if (!fs::is_regular_file(path))
  {
    throw Error(ErrorCode::CannotRead, fs::exists(path) ? "is not a regular file" : "no such file");
  }
}

} // namespace medial
