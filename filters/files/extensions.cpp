#include "files/extensions.h"

#include "files/file_content.h"

#include "medial/error.h"

#include <algorithm>

namespace fs = std::filesystem;

namespace medial::files
{

bool hasExtension(const fs::path& path, const Extensions& extensions)
{
  return std::find(extensions.begin(), extensions.end(), extensionOf(path)) != extensions.end();
}

std::string joined(const Extensions& extensions, const std::string& between)
{
  std::string text;
  for (const std::string& extension : extensions)
  {
    text += (text.empty() ? "" : between) + extension;
  }
  return text;
}

std::string enumerated(const Extensions& extensions)
{
  if (extensions.size() < 2)
  {
    return joined(extensions, "");
  }
  return joined({ extensions.begin(), extensions.end() - 1 }, ", ") + " or " + extensions.back();
}

std::string unknownExtension(const fs::path& path, const Extensions& allowed)
{
  return "unknown extension '" + extensionOf(path) + "', allowed: " + joined(allowed, " ");
}

void requireExtension(const fs::path& path, const Extensions& allowed)
{
  requireRegularFile(path);
  if (!hasExtension(path, allowed))
  {
    throw Error(ErrorCode::CannotRead, path.string() + ": " + unknownExtension(path, allowed));
  }
}

} // namespace medial::files
