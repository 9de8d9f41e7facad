#include "base/huge_pages.h"

#include <gtest/gtest.h>

#include <sys/mman.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

namespace medial
{
namespace
{

constexpr std::size_t kCount = std::size_t{ 4 } << 20;

/// Whether the system was asked for huge pages at an address: its mapping has the flag "hg".
bool isAdvised(const void* address)
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
bool systemListsHugePages()
{
  void* pages = mmap(nullptr, kCount, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  if (pages == MAP_FAILED)
  {
    return false;
  }
  const bool listed = madvise(pages, kCount, MADV_HUGEPAGE) == 0 && isAdvised(pages);
  munmap(pages, kCount);
  return listed;
}

TEST(HugePages, AreAskedForWhereAVectorIsLarge)
{
  if (!systemListsHugePages())
  {
    GTEST_SKIP() << "this system does not list huge pages";
  }
  const std::vector<std::uint8_t> large = largeVector<std::uint8_t>(kCount);
  EXPECT_TRUE(isAdvised(large.data() + kCount / 2));
}

TEST(HugePages, ElementsAreThoseOfAnOrdinaryVector)
{
  std::vector<int> elements{ 1, 2, 3 };
  resizeLarge(elements, kCount, 7);
  ASSERT_EQ(elements.size(), kCount);
  EXPECT_EQ(std::vector<int>(elements.begin(), elements.begin() + 3),
    (std::vector<int>{ 1, 2, 3 }));
  EXPECT_EQ(std::count(elements.begin() + 3, elements.end(), 7),
    static_cast<std::ptrdiff_t>(kCount) - 3);
  resizeLarge(elements, 2);
  EXPECT_EQ(elements, (std::vector<int>{ 1, 2 }));
  EXPECT_TRUE(largeVector<double>(0).empty());
}

// The memory has often been used before.
TEST(HugePages, ZeroedVectorsAreZeroUntilSomethingIsAssigned)
{
  for (const std::size_t count : { std::size_t{ 100 }, std::size_t{ kCount } })
  {
    static_cast<void>(std::vector<int>(count, -1));
    ZeroedVector<int> zeros(count);
    EXPECT_EQ(std::count(zeros.begin(), zeros.end(), 0), static_cast<std::ptrdiff_t>(count));
    zeros.back() = 3;
    const ZeroedVector<int> copy = zeros;
    EXPECT_EQ(copy, zeros);
    zeros.push_back(4);
    EXPECT_EQ(std::vector<int>(zeros.end() - 2, zeros.end()), (std::vector<int>{ 3, 4 }));
  }
}

TEST(HugePages, ReservingKeepsWhatIsThere)
{
  std::vector<std::string> words{ "field", "axis" };
  reserveLarge(words, 100000);
  EXPECT_GE(words.capacity(), 100000U);
  EXPECT_EQ(words, (std::vector<std::string>{ "field", "axis" }));
}

} // namespace
} // namespace medial
