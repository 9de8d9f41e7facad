#include "medial/common/memory_guard.h"

#include <algorithm>
#include <fstream>
#include <iomanip>
#include <limits>
#include <sstream>

namespace medial
{
namespace
{

constexpr double kUnknown = std::numeric_limits<double>::infinity();
constexpr double kGibibyte = 1024.0 * 1024.0 * 1024.0;

/// Bytes that the system can still give away, swap included.
double systemMemory()
{
  std::ifstream stream("/proc/meminfo");
  std::string name;
  std::string unit;
  double kibibytes = 0.0;
  double available = -1.0;
  double swap = 0.0;
  while (stream >> name >> kibibytes && std::getline(stream, unit))
  {
    if (name == "MemAvailable:")
    {
      available = kibibytes;
    }
    else if (name == "SwapFree:")
    {
      swap = kibibytes;
    }
  }
  return available < 0.0 ? kUnknown : 1024.0 * (available + swap);
}

/// Bytes that the container may have; its file has the word "max" where there is no limit.
double containerMemory()
{
  std::ifstream stream("/sys/fs/cgroup/memory.max");
  double bytes = 0.0;
  return stream >> bytes ? bytes : kUnknown;
}

} // namespace

void requireMemory(std::int64_t gridPoints, std::int64_t bytesPerPoint)
{
  const double needed = static_cast<double>(gridPoints) * static_cast<double>(bytesPerPoint);
  const double left = std::min(systemMemory(), containerMemory());
  if (needed > left)
  {
    std::ostringstream message;
    message << std::fixed << std::setprecision(1) << gridPoints << " grid points need "
            << needed / kGibibyte << " GiB of memory, and " << left / kGibibyte
            << " GiB are left; a coarser grid needs less";
    throw Error(ErrorCode::OutOfMemory, message.str());
  }
}

} // namespace medial
