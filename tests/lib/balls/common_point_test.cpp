// Whether balls overlap, pairwise or all of them.
#include "balls/common_point.h"

#include <gtest/gtest.h>

#include <cmath>

namespace medial::test
{
namespace
{

/// Balls of one radius around the corners of a regular triangle at distance 1 from the origin.
std::vector<Ball> aroundTriangle(double radius)
{
  std::vector<Ball> balls;
  for (int i = 0; i < 3; ++i)
  {
    const double angle = 2.0 * std::acos(-1.0) * i / 3;
    balls.push_back({ { std::cos(angle), std::sin(angle), 0.0 }, radius });
  }
  return balls;
}

TEST(CommonPoint, OfThreeBallsWhereTheyReachTheMiddle)
{
  EXPECT_FALSE(haveCommonPoint(aroundTriangle(0.99))); // overlap pairwise
  EXPECT_TRUE(haveCommonPoint(aroundTriangle(1.01)));
}

TEST(CommonPoint, OfFourBalls)
{
  std::vector<Ball> balls = aroundTriangle(1.05);
  balls.push_back({ { 0.0, 0.0, 1.0 }, 0.5 });
  EXPECT_FALSE(haveCommonPoint(balls));
  balls.back().radius = 0.9;
  EXPECT_TRUE(haveCommonPoint(balls));
}

TEST(CommonPoint, OfABallWithinAnother)
{
  EXPECT_TRUE(haveCommonPoint({ { { 0.0, 0.0, 0.0 }, 1.0 }, { { 0.2, 0.0, 0.0 }, 0.1 } }));
  EXPECT_FALSE(haveCommonPoint({ { { 0.0, 0.0, 0.0 }, 1.0 }, { { 3.0, 0.0, 0.0 }, 1.0 } }));
}

} // namespace
} // namespace medial::test
