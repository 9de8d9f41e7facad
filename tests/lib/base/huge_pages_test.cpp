#include "base/huge_pages.h"

#include "support/huge_pages.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace medial
{
namespace
{

constexpr std::size_t kCount = std::size_t{ 4 } << 20;

TEST(HugePages, AreAskedForWhereAVectorIsLarge)
{
  if (!test::systemListsHugePages())
  {
    GTEST_SKIP() << "this system does not list huge pages";
  }
  const std::vector<std::uint8_t> large = largeVector<std::uint8_t>(kCount);
  EXPECT_TRUE(test::isAdvised(large.data() + kCount / 2));
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
