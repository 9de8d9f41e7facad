#include "huge_heap.h"

#include "support/huge_pages.h"
#include "support/sanitizers.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdlib>
#include <vector>

#include <sys/resource.h>

namespace medial::test
{
namespace
{

constexpr std::size_t kBytes = 20 << 20;

/// Whether the middle of a block that is allocated now has huge pages, where there are any.
bool nextBlockHasAdvice()
{
  const std::vector<char> block(kBytes, 1);
  return isAdvised(block.data() + kBytes / 2);
}

/// Whether those that the heap asks for are listed. Blocks of sanitizers are not glibc's.
bool heapListsHugePages()
{
  return !kUnderAddressSanitizer && !kUnderThreadSanitizer && systemListsHugePages();
}

// Each in a process of its own, since the heap stays as it is.
TEST(HugeHeapDeathTest, GivesBlocksHugePages)
{
  const auto ask = []
  {
    const bool before = nextBlockHasAdvice();
    app::useHugeHeap();
    std::exit(!before && nextBlockHasAdvice() == heapListsHugePages() ? 0 : 1);
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
