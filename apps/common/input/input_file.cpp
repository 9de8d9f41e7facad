#include "input/input_file.h"

#include "failure.h"
#include "library_calls.h"
#include "vtk_messages.h"

namespace fs = std::filesystem;

namespace medial::app
{

std::string stemOf(const fs::path& path)
{
  const std::string name = path.filename().string();
  return name.substr(0, name.size() - extensionOf(path).size());
}

void refuseFile(const fs::path& path, const std::string& why)
{
  throw Failure(ExitCode::BadInput, path.string() + ": " + why);
}

void requireRegularFile(const fs::path& path)
{
  withFailures([&] { files::requireRegularFile(path); });
}

std::string readContent(const fs::path& path)
{
  std::string content;
  withFailures([&] { content = files::readContent(path); });
  return content;
}

void withReaderFailures(const fs::path& path, const std::function<void()>& work)
{
  const VtkMessages messages;
  withFailures(work);
  if (!messages.first().empty())
  {
    refuseFile(path, messages.first());
  }
}

} // namespace medial::app
