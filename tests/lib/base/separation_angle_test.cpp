#include "base/separation_angle.h"

#include <gtest/gtest.h>

#include <random>

namespace medial::test
{
namespace
{

/// The shortcut decides as the angle itself does, also at the limit, at 0 and at 180 degrees.
TEST(SeparationAngle, LimitIsReachedAsTheAngleTells)
{
  std::mt19937 random(1);
  std::uniform_real_distribution<double> coordinate(-1.0, 1.0);
  const auto any = [&]
  { return glm::dvec3(coordinate(random), coordinate(random), coordinate(random)); };
  for (int i = 0; i < 10000; ++i)
  {
    const glm::dvec3 x = any();
    const glm::dvec3 a = any();
    const glm::dvec3 b = i % 7 == 0 ? x + 2.0 * (a - x) : i % 7 == 1 ? x - 2.0 * (a - x) : any();
    const double angle = separationAngle(x, a, b);
    for (const double limit :
      { angle, angle + 1e-15, angle - 1e-15, angle + 1e-6, angle - 1e-6, 0.5, 3.0 })
    {
      EXPECT_EQ(AngleLimit(limit).isReached(x, a, b), angle >= limit);
    }
    EXPECT_EQ(AngleLimit(0.1).isReached(x, x, b), separationAngle(x, x, b) >= 0.1);
  }
}

} // namespace
} // namespace medial::test
