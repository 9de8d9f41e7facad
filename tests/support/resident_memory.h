#pragma once

#include "sanitizers.h"

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

/// By how much it may grow over many frames of the same work, MiB. AddressSanitizer keeps freed
/// memory for a while.
constexpr double kAllowedGrowth = kUnderAddressSanitizer ? 512.0 : 4.0;

} // namespace medial::test
