#include "methods/slice_polygon.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace medial::benchmark
{
namespace
{

TEST(SlicePolygon, StartsHalfAGridPointWider)
{
  const SlicePolygon polygon({ 3.0f, 1.0f });
  EXPECT_EQ(polygon.size(), 4);
  EXPECT_DOUBLE_EQ(polygon.area(), 8.0);
  EXPECT_TRUE(polygon.coversGridPoint());
}

TEST(SlicePolygon, KeepsTheSideBelowTheLimit)
{
  SlicePolygon polygon({ 3.0f, 1.0f });
  polygon.clip({ 1.0f, 0.0f, 0.0f }, 1.5f); // i <= 1.5
  EXPECT_NEAR(polygon.area(), 4.0, 1e-6);
  polygon.clip({ -1.0f, 0.0f, 0.0f }, -2.0f); // i >= 2
  EXPECT_TRUE(polygon.empty());
}

TEST(SlicePolygon, ADiagonalCutAddsOneCorner)
{
  SlicePolygon polygon({ 3.0f, 3.0f });
  polygon.clip({ 1.0f, 1.0f, 0.0f }, 5.0f);
  EXPECT_EQ(polygon.size(), 5);
  EXPECT_NEAR(polygon.area(), 16.0 - 2.0, 1e-5);
}

TEST(SlicePolygon, SnappedCornersAreMultiplesOfASubpixel)
{
  SlicePolygon polygon({ 5.0f, 5.0f });
  polygon.clip({ 0.3f, 0.7f, 0.1f }, 2.0f);
  const double before = polygon.area();
  polygon.snap();
  for (int i = 0; i < polygon.size(); ++i)
  {
    EXPECT_EQ(polygon.corner(i) * 256.0f, glm::round(polygon.corner(i) * 256.0f));
  }
  EXPECT_NEAR(polygon.area(), before, 0.05);
}

TEST(SlicePolygon, SnappingJoinsCornersThatBecomeOne)
{
  SlicePolygon polygon({ 5.0f, 5.0f });
  polygon.clip({ 1.0f, 1.0f, 0.0f }, 10.999f); // cuts off a corner of 0.001
  EXPECT_EQ(polygon.size(), 5);
  polygon.snap();
  EXPECT_EQ(polygon.size(), 4);
}

/// As above the apex of a cone with very many edges: corners lie within rounding of the next edge.
TEST(SlicePolygon, VeryManySidesNeverMakeTooManyCorners)
{
  for (int edges : { 64, 250, 1000, 5000 })
  {
    for (float slice = 0.001f; slice < 0.02f; slice += 0.0005f)
    {
      SlicePolygon polygon({ 7.0f, 7.0f });
      for (int i = 0; i < edges && !polygon.empty(); ++i)
      {
        const float angle = 6.2831853f * static_cast<float>(i) / static_cast<float>(edges);
        const float a = 0.7f * std::cos(angle);
        const float b = 0.7f * std::sin(angle);
        polygon.clip({ a, b, -3.3f * a - 3.7f * b - 0.7f * slice }, 0.0005f);
        ASSERT_LE(polygon.size(), 32);
      }
    }
  }
}

double minFanHeight(const SlicePolygon& polygon, int start)
{
  double min = 1e9;
  for (int i = 1; i + 1 < polygon.size(); ++i)
  {
    const glm::dvec2 p(polygon.corner(start));
    const glm::dvec2 u = glm::dvec2(polygon.corner(start + i)) - p;
    const glm::dvec2 v = glm::dvec2(polygon.corner(start + i + 1)) - p;
    const double longest = std::max({ glm::length(u), glm::length(v), glm::length(v - u) });
    min = std::min(min, std::abs(u.x * v.y - u.y * v.x) / longest);
  }
  return min;
}

TEST(SlicePolygon, FansStartWhereTheirLowestTriangleIsHighEnoughOrHighest)
{
  std::mt19937 random(5);
  std::uniform_real_distribution<float> slope(-1.0f, 1.0f);
  int improved = 0;
  for (int round = 0; round < 2000; ++round)
  {
    SlicePolygon polygon({ 40.0f, 3.0f });
    for (int cut = 0; cut < 5; ++cut)
    {
      polygon.clip({ 0.1f * slope(random), slope(random), 0.0f }, 0.5f);
    }
    polygon.snap();
    if (polygon.empty())
    {
      continue;
    }
    double highest = 0.0;
    for (int start = 0; start < polygon.size(); ++start)
    {
      highest = std::max(highest, minFanHeight(polygon, start));
    }
    const double chosen = minFanHeight(polygon, polygon.fanStart());
    EXPECT_GE(chosen, std::min(0.0499, 0.999 * highest));
    improved += chosen > minFanHeight(polygon, 0) ? 1 : 0;
  }
  EXPECT_GT(improved, 10) << "the polygons do not test the choice";
}

TEST(SlicePolygon, BetweenGridPointsItCoversNone)
{
  SlicePolygon polygon({ 5.0f, 5.0f });
  polygon.clip({ 1.0f, 0.0f, 0.0f }, 2.75f);
  polygon.clip({ -1.0f, 0.0f, 0.0f }, -2.25f);
  EXPECT_FALSE(polygon.empty());
  EXPECT_FALSE(polygon.coversGridPoint());
}

} // namespace
} // namespace medial::benchmark
