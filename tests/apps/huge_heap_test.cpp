#include "huge_heap.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <sys/resource.h>
#include <vector>

namespace medial::test
{
namespace
{

constexpr std::size_t kBytes = 20 << 20;

/// Whether the system has been asked for huge pages at an address.
bool hasAdvice(const void* address)
{
  const auto wanted = reinterpret_cast<std::uintptr_t>(address);
  std::ifstream file("/proc/self/smaps");
  bool here = false;
  for (std::string line; std::getline(file, line);)
  {
    std::uintptr_t begin = 0;
    std::uintptr_t end = 0;
    char dash = 0;
    std::istringstream text(line);
    if (text >> std::hex >> begin >> dash >> end && dash == '-')
    {
      here = begin <= wanted && wanted < end;
    }
    if (here && line.rfind("VmFlags:", 0) == 0)
    {
      return line.find(" hg") != std::string::npos;
    }
  }
  return false;
}

/// Whether the middle of a block that is allocated now has huge pages, where there are any.
bool nextBlockHasAdvice()
{
  const std::vector<char> block(kBytes, 1);
  return hasAdvice(block.data() + kBytes / 2);
}

bool systemHasHugePages()
{
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  return false; // blocks are not glibc's
#else
  return std::filesystem::exists("/sys/kernel/mm/transparent_hugepage/enabled");
#endif
}

// Each in a process of its own, since the heap stays as it is.
TEST(HugeHeapDeathTest, GivesBlocksHugePages)
{
  const auto ask = []
  {
    const bool before = nextBlockHasAdvice();
    app::useHugeHeap();
    std::exit(!before && nextBlockHasAdvice() == systemHasHugePages() ? 0 : 1);
  };
  EXPECT_EXIT(ask(), testing::ExitedWithCode(0), "");
}

TEST(HugeHeapDeathTest, TakesNoAddressesWhereTheyAreLimited)
{
  const auto ask = []
  {
    rlimit limit{};
    getrlimit(RLIMIT_DATA, &limit);
    limit.rlim_cur = rlim_t{ 1 } << 62; // AddressSanitizer takes terabytes
    setrlimit(RLIMIT_DATA, &limit);
    app::useHugeHeap();
    std::exit(nextBlockHasAdvice() ? 1 : 0);
  };
  EXPECT_EXIT(ask(), testing::ExitedWithCode(0), "");
}

} // namespace
} // namespace medial::test
