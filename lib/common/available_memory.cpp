#include "medial/common/available_memory.h"

#include "medial/common/error.h"

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

/// The file holds the word "max" where there is no limit.
std::uint64_t groupLimit()
{
  std::string group = "/";
  std::ifstream groups("/proc/self/cgroup");
  for (std::string line; std::getline(groups, line);)
  {
    if (line.rfind("0::", 0) == 0)
    {
      group = line.substr(3);
    }
  }
  std::ifstream file("/sys/fs/cgroup" + group + "/memory.max");
  std::uint64_t bytes = 0;
  return file >> bytes ? bytes : kUnknown;
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
  return std::min(systemMemory(), groupLimit());
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
