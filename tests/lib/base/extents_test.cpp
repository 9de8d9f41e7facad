#include "base/extents.h"

#include <gtest/gtest.h>

#include <vector>

namespace medial::test
{
namespace
{

const Extent kWhole{ { 2, 0, -1 }, { 9, 7, 6 } };
const Extent kPart{ { 3, 2, 3 }, { 5, 7, 4 } };

void expectExtent(const Extent& extent, const std::array<int, 3>& min,
  const std::array<int, 3>& max)
{
  EXPECT_EQ(extent.min, min);
  EXPECT_EQ(extent.max, max);
}

TEST(Extents, GrowAsFarAsTheGridGoes)
{
  expectExtent(grown(kPart, 2), { 1, 0, 1 }, { 7, 9, 6 });
  expectExtent(grown(kPart, 2, kWhole), { 2, 0, 1 }, { 7, 7, 6 });
  expectExtent(grownUpwards(kPart, 3, kWhole), { 3, 2, 3 }, { 8, 7, 6 });
  expectExtent(grown(kPart, 0, kWhole), kPart.min, kPart.max);
}

TEST(Extents, StayEmpty)
{
  EXPECT_TRUE(grown(Extent(), 2).empty());
  EXPECT_TRUE(grown(Extent(), 2, kWhole).empty());
  EXPECT_TRUE(grownUpwards(Extent(), 2, kWhole).empty());
  EXPECT_TRUE(commonPart(kPart, { { 6, 2, 3 }, { 9, 7, 4 } }).empty());
}

TEST(Extents, HavePointsUpToTheirEndsAndCellsUpToTheLastPoints)
{
  EXPECT_TRUE(hasPoint(kPart, { 3, 2, 3 }));
  EXPECT_TRUE(hasPoint(kPart, { 5, 7, 4 }));
  EXPECT_FALSE(hasPoint(kPart, { 2, 2, 3 }));
  EXPECT_FALSE(hasPoint(kPart, { 5, 8, 4 }));
  EXPECT_FALSE(hasPoint(Extent(), { 0, 0, 0 }));
  EXPECT_TRUE(hasCell(kPart, { 4, 6, 3 }));
  EXPECT_FALSE(hasCell(kPart, { 4, 6, 4 }));
  EXPECT_FALSE(hasCell(kPart, { 2, 6, 3 }));
}

TEST(Extents, PartsCoverThemOnce)
{
  std::vector<Extent> parts;
  visitParts(kPart, 4, [&](const Extent& part) { parts.push_back(part); });
  ASSERT_EQ(parts.size(), 2U);
  expectExtent(parts[0], { 3, 2, 3 }, { 5, 5, 4 });
  expectExtent(parts[1], { 3, 6, 3 }, { 5, 7, 4 });
  expectExtent(wholeParts(kPart, 4, kWhole), { 2, 0, 3 }, { 5, 7, 6 });
}

} // namespace
} // namespace medial::test
