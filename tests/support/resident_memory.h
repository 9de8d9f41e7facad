#pragma once

#include <fstream>

#include <unistd.h>

namespace medial::test
{

/// Resident memory of this process, MiB.
inline double residentMiB()
{
  std::ifstream file("/proc/self/statm");
  double total = 0.0;
  double resident = 0.0;
  file >> total >> resident;
  return resident * static_cast<double>(sysconf(_SC_PAGESIZE)) / (1 << 20);
}

} // namespace medial::test
