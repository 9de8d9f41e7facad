#include "sign/side_parts.h"

#include "base/extents.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

using namespace medial;

namespace
{

/// Rows that enter and leave a solid at random points.
InsideRows randomRows(const Extent& extent, std::uint32_t seed)
{
  std::mt19937 random(seed);
  std::vector<SliceCrossings> slices(extent.size(2));
  for (SliceCrossings& slice : slices)
  {
    for (int j = extent.min[1]; j <= extent.max[1]; ++j)
    {
      int change = 1;
      for (int i = extent.min[0]; i <= extent.max[0] && random() % 4 != 0; change = -change)
      {
        i += static_cast<int>(random() % 40);
        if (i <= extent.max[0])
        {
          slice.push_back({ j, i, change });
        }
      }
    }
  }
  return { extent, slices };
}

bool hasPoints(const InsideRows& inside, Side side, const Extent& part)
{
  for (int k = part.min[2]; k <= part.max[2]; ++k)
  {
    for (int j = part.min[1]; j <= part.max[1]; ++j)
    {
      for (int i = part.min[0]; i <= part.max[0]; ++i)
      {
        if (side == Side::Both || inside.contains({ i, j, k }) == (side == Side::Interior))
        {
          return true;
        }
      }
    }
  }
  return false;
}

} // namespace

TEST(SideParts, AreThoseWithAPointOfTheSideInTheExtentOrNextToIt)
{
  constexpr int kSize = 4;
  const Extent whole{ { -3, 2, 1 }, { 57, 20, 17 } };
  int with = 0;
  int without = 0;
  const auto compare = [&](const InsideRows& inside, Side side, const Extent& extent, int margin)
  {
    const SideParts parts(inside, side, extent, whole, kSize, margin);
    for (const int size : { kSize, 2 * kSize })
    {
      visitParts(wholeParts(extent, size, whole), size,
        [&](const Extent& part)
        {
          const bool expected =
            hasPoints(inside, side, grown(commonPart(part, extent), margin, whole));
          EXPECT_EQ(parts.meets(part), expected);
          ++(expected ? with : without);
        });
    }
  };
  for (std::uint32_t seed = 0; seed < 20; ++seed)
  {
    const InsideRows inside = randomRows(whole, seed);
    for (const Extent& extent :
      { whole, Extent{ { -3, 2, 4 }, { 57, 20, 6 } }, Extent{ { 0, 5, 17 }, { 30, 11, 17 } } })
    {
      for (const Side side : { Side::Interior, Side::Exterior, Side::Both })
      {
        for (const int margin : { 0, 1, 3 })
        {
          compare(inside, side, extent, margin);
        }
      }
    }
  }
  EXPECT_GT(with, 1000);
  EXPECT_GT(without, 1000);
}
