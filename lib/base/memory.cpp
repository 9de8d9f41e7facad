#include "medial/memory.h"

#include "medial/error.h"

#include <algorithm>
#include <fstream>
#include <limits>
#include <string>

namespace medial
{
namespace
{

constexpr std::uint64_t kUnknown = std::numeric_limits<std::uint64_t>::max();
constexpr std::uint64_t kMebibyte = 1024 * 1024;

std::uint64_t systemMemory()
{
  std::ifstream file("/proc/meminfo");
  std::string name;
  std::uint64_t kibibytes = 0;
  while (file >> name >> kibibytes)
  {
    if (name == "MemAvailable:")
    {
      return 1024 * kibibytes;
    }
    file.ignore(std::numeric_limits<std::streamsize>::max(), '\n');
  }
  return kUnknown;
}

std::uint64_t numberIn(const std::string& path)
{
  std::ifstream file(path);
  std::uint64_t number = 0;
  return file >> number ? number : kUnknown; // without a limit the file has the word "max"
}

/// Returns the memory that a control group uses and cannot give back. Cached files can be given
/// back.
std::uint64_t usedBy(const std::string& group)
{
  const std::uint64_t current = numberIn(group + "/memory.current");
  if (current == kUnknown)
  {
    return 0;
  }
  std::ifstream file(group + "/memory.stat");
  std::string name;
  std::uint64_t bytes = 0;
  while (file >> name >> bytes)
  {
    if (name == "inactive_file")
    {
      return current - std::min(current, bytes);
    }
  }
  return current;
}

/// Returns the memory that the limits of the process's control group, and of those around it,
/// leave.
std::uint64_t groupMemory()
{
  std::string group;
  std::ifstream groups("/proc/self/cgroup");
  for (std::string line; std::getline(groups, line);)
  {
    if (line.rfind("0::", 0) == 0)
    {
      group = line.substr(3);
    }
  }
  std::uint64_t left = kUnknown;
  for (;; group.erase(group.find_last_of('/')))
  {
    const std::string folder = "/sys/fs/cgroup" + group;
    const std::uint64_t limit = numberIn(folder + "/memory.max");
    if (limit != kUnknown)
    {
      left = std::min(left, limit - std::min(limit, usedBy(folder)));
    }
    if (group.find('/') == std::string::npos)
    {
      return left;
    }
  }
}

void require(const std::string& what, std::uint64_t bytes, const std::string& detail,
  const char* advice)
{
  const std::uint64_t available = availableMemory();
  if (bytes > available)
  {
    throw Error(ErrorCode::OutOfMemory,
      what + " needs " + std::to_string(bytes / kMebibyte) + " MiB" + detail + ", but only " +
        std::to_string(available / kMebibyte) + " MiB are available; " + advice);
  }
}

} // namespace

std::uint64_t availableMemory()
{
  return std::min(systemMemory(), groupMemory());
}

void requireMemory(const std::string& what, std::uint64_t bytes)
{
  require(what, bytes, "", "use a coarser grid");
}

void requireMemory(std::int64_t gridPoints, std::size_t bytesPerPoint)
{
  require("a grid of " + std::to_string(gridPoints) + " points",
    static_cast<std::uint64_t>(gridPoints) * bytesPerPoint,
    " (" + std::to_string(bytesPerPoint) + " bytes a point)",
    "use a coarser grid, or fewer arrays");
}

} // namespace medial
