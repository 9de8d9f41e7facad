#pragma once

#include <cstddef>
#include <cstdint>
#include <fstream>
#include <sstream>
#include <string>

#include <sys/mman.h>

namespace medial::test
{

/// Whether the system was asked for huge pages at an address: its mapping has the flag "hg".
inline bool isAdvised(const void* address)
{
  const auto wanted = reinterpret_cast<std::uintptr_t>(address);
  std::ifstream maps("/proc/self/smaps");
  std::string line;
  bool inside = false;
  while (std::getline(maps, line))
  {
    std::uintptr_t begin = 0;
    std::uintptr_t end = 0;
    char dash = 0;
    std::istringstream words(line);
    if (words >> std::hex >> begin >> dash >> end && dash == '-')
    {
      inside = begin <= wanted && wanted < end;
    }
    if (inside && line.compare(0, 8, "VmFlags:") == 0)
    {
      return line.find(" hg") != std::string::npos;
    }
  }
  return false;
}

/// Whether pages that are asked to be huge are listed as such here: not every kernel has them, and
/// not every sandbox shows them.
inline bool systemListsHugePages()
{
  constexpr std::size_t kBytes = std::size_t{ 4 } << 20;
  void* pages = mmap(nullptr, kBytes, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  if (pages == MAP_FAILED)
  {
    return false;
  }
  const bool listed = madvise(pages, kBytes, MADV_HUGEPAGE) == 0 && isAdvised(pages);
  munmap(pages, kBytes);
  return listed;
}

} // namespace medial::test
