#include "medial/error.h"
#include "medial/grid.h"

#include "support/errors.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

using namespace medial;
using namespace medial::test;

namespace
{

const double kNan = std::numeric_limits<double>::quiet_NaN();
const double kInfinity = std::numeric_limits<double>::infinity();

void expectCovers(const Grid& grid, const Bounds& bounds, double margin)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    const double last = grid.origin[axis] + grid.spacing[axis] * (grid.dimensions[axis] - 1);
    const double tolerance = 1e-6 * grid.spacing[axis];
    EXPECT_LE(grid.origin[axis], bounds.min[axis] - margin + tolerance);
    EXPECT_GE(last, bounds.max[axis] + margin - tolerance);
    EXPECT_NEAR(0.5 * (grid.origin[axis] + last), 0.5 * (bounds.min[axis] + bounds.max[axis]),
      tolerance);
  }
}

} // namespace

TEST(Bounds, OfNothingChangeNoOthers)
{
  EXPECT_TRUE(kEmptyBounds.empty());
  EXPECT_TRUE(boundsOf({}).empty());
  const Bounds one = boundsOf({ { 1.0, -2.0, 3.0 } });
  EXPECT_FALSE(one.empty());
  const Bounds same = joined(kEmptyBounds, joined(one, kEmptyBounds));
  EXPECT_EQ(same.min, (Point3{ 1.0, -2.0, 3.0 }));
  EXPECT_EQ(same.max, same.min);
}

TEST(Bounds, ContainWhatTheyAreJoinedOf)
{
  const Bounds bounds =
    joined(boundsOf({ { 0.0, 5.0, 1.0 }, { 2.0, 4.0, 1.5 } }), boundsOf({ { 1.0, 6.0, -1.0 } }));
  EXPECT_EQ(bounds.min, (Point3{ 0.0, 4.0, -1.0 }));
  EXPECT_EQ(bounds.max, (Point3{ 2.0, 6.0, 1.5 }));
}

TEST(Grid, ResolutionIsTheCountAlongTheLongestAxis)
{
  const Bounds bounds{ { 0, 0, 0 }, { 3, 2, 1 } };
  const Grid grid = makeGrid(bounds, 31, 0.0);
  EXPECT_EQ(grid.dimensions, (std::array<int, 3>{ 31, 21, 11 }));
  EXPECT_DOUBLE_EQ(grid.spacing[0], 0.1);
  expectCovers(grid, bounds, 0.0);
}

TEST(Grid, PaddingIsAFractionOfTheDiagonal)
{
  const Bounds bounds{ { -1, -2, -2 }, { 1, 2, 2 } };
  const Grid grid = makeGrid(bounds, 64, 0.5);
  EXPECT_NEAR(grid.origin[1], -2.0 - 3.0, 1e-12);
  EXPECT_EQ(grid.dimensions[1], 64);
  expectCovers(grid, bounds, 3.0);
}

TEST(Grid, EqualAxesGetEqualCountsFarFromTheOrigin)
{
  for (const int resolution : { 2, 7, 100, 255, 256, 8192 })
  {
    const Bounds bounds{ { 1e6, 1e-3, -3e5 }, { 1e6 + 0.1, 1e-3 + 0.1, -3e5 + 0.1 } };
    const Grid grid = makeGrid(bounds, resolution);
    EXPECT_EQ(grid.dimensions, (std::array<int, 3>{ resolution, resolution, resolution }));
  }
}

TEST(Grid, ResolutionIsExactForAwkwardLengths)
{
  for (int i = 1; i < 200; ++i)
  {
    const Bounds bounds{ { 0.1 * i, 0, 0 }, { 0.1 * i + 1.0 / i, 0.3 / i, 0.7 / i } };
    const Grid grid = makeGrid(bounds, i + 1);
    EXPECT_EQ(grid.dimensions[0], i + 1);
    expectCovers(grid, bounds, kDefaultPadding * bounds.diagonal());
  }
}

TEST(Grid, FlatBoundsWithoutPaddingAreOnePointThick)
{
  const Bounds bounds{ { 0, 0, 5 }, { 1, 1, 5 } };
  const Grid grid = makeGrid(bounds, 11, 0.0);
  EXPECT_EQ(grid.dimensions, (std::array<int, 3>{ 11, 11, 1 }));
  EXPECT_EQ(grid.origin[2], 5.0);
}

TEST(Grid, ASinglePointGetsAMarginOfOne)
{
  const Grid grid = makeGrid({ { 7, 8, 9 }, { 7, 8, 9 } }, 5, 0.0);
  EXPECT_EQ(grid.dimensions, (std::array<int, 3>{ 5, 5, 5 }));
  EXPECT_EQ(grid.origin, (Point3{ 6, 7, 8 }));
  EXPECT_EQ(grid.spacing, (Point3{ 0.5, 0.5, 0.5 }));
}

TEST(Grid, SpacingMayDifferByAxis)
{
  const Bounds bounds{ { 0, 0, 0 }, { 1, 1, 1 } };
  const Grid grid = makeGridWithSpacing(bounds, { 0.1, 0.25, 0.3 }, 0.0);
  EXPECT_EQ(grid.dimensions, (std::array<int, 3>{ 11, 5, 5 }));
  expectCovers(grid, bounds, 0.0);
}

TEST(Grid, ErrorsNameValueAndRange)
{
  const Bounds unit{ { 0, 0, 0 }, { 1, 1, 1 } };
  EXPECT_EQ(messageOf([&] { makeGrid(unit, 0); }), "resolution 0 is outside [2, 8192]");
  EXPECT_EQ(messageOf([&] { makeGrid(unit, 8193); }), "resolution 8193 is outside [2, 8192]");
  EXPECT_EQ(messageOf([&] { makeGrid(unit, 10, -0.5); }), "padding -0.5 is outside [0, 10]");
  EXPECT_EQ(messageOf([&] { makeGrid(unit, 10, 11); }), "padding 11 is outside [0, 10]");
  EXPECT_NE(messageOf([&] { makeGrid(unit, 10, kNan); }), "");
  EXPECT_EQ(messageOf(
              [&] {
                makeGridWithSpacing(unit, { 1, 0, 1 });
              }),
    "spacing along y 0 is outside (0, infinity)");
  EXPECT_EQ(messageOf(
              [&] {
                makeGridWithSpacing(unit, { 1, 1, 1e-4 }, 0.0);
              }),
    "spacing 0.0001 along z needs 10001 points, more than 8192");
  EXPECT_NE(messageOf([&] { makeGridWithSpacing(unit, { 1, 1, 1e-300 }); }), "");
}

TEST(Grid, BoundsMustBeFiniteAndOrdered)
{
  EXPECT_EQ(messageOf(
              [] {
                makeGrid({ { 0, 1, 0 }, { 1, 0, 1 } });
              }),
    "bounds [1, 0] along y are not finite with min <= max");
  EXPECT_NE(messageOf([] { makeGrid({ { 0, 0, kNan }, { 1, 1, 1 } }); }), "");
  EXPECT_NE(messageOf([] { makeGrid({ { 0, 0, 0 }, { 1, 1, kInfinity } }); }), "");
  EXPECT_NE(messageOf([] { makeGrid({ { -1e308, 0, 0 }, { 1e308, 1, 1 } }); }), "");
}

TEST(Grid, ExplicitGridsAreChecked)
{
  Grid grid;
  EXPECT_NO_THROW(validateGrid(grid));
  grid.dimensions = { 4, 0, 4 };
  EXPECT_EQ(messageOf([&] { validateGrid(grid); }), "dimension along y 0 is outside [1, 8192]");
  grid.dimensions = { 4, 4, 4 };
  grid.spacing[2] = -1.0;
  EXPECT_EQ(messageOf([&] { validateGrid(grid); }), "spacing along z -1 is outside (0, infinity)");
  grid.spacing[2] = 1.0;
  grid.origin[0] = kInfinity;
  EXPECT_EQ(messageOf([&] { validateGrid(grid); }), "origin inf along x is not finite");
}

TEST(Grid, PointsFollowOriginAndSpacing)
{
  const Grid grid{ { 1, 2, 3 }, { 0.5, 1, 2 }, { 8192, 8192, 64 } };
  EXPECT_EQ(grid.point(2, 3, 4), (Point3{ 2, 5, 11 }));
  EXPECT_EQ(grid.pointCount(), std::int64_t{ 1 } << 32);
  EXPECT_EQ(grid.wholeExtent().max, (std::array<int, 3>{ 8191, 8191, 63 }));
}

TEST(Grid, LargestHasMorePointsThanAnIdOf32Bits)
{
  const Grid grid{ {}, { 1, 1, 1 }, { kMaxDimension, kMaxDimension, kMaxDimension } };
  validateGrid(grid);
  EXPECT_EQ(grid.pointCount(), std::int64_t{ 1 } << 39);
}

TEST(Extent, CountsAndContains)
{
  const Extent all{ { 0, 0, 0 }, { 9, 9, 9 } };
  const Extent part{ { 2, 0, 9 }, { 4, 9, 9 } };
  EXPECT_EQ(part.pointCount(), 30);
  EXPECT_TRUE(all.contains(part));
  EXPECT_FALSE(part.contains(all));
  EXPECT_TRUE(Extent{}.empty());
  EXPECT_EQ(Extent{}.pointCount(), 0);
}
