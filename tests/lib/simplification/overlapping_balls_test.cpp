// Compares the nearest overlapping ball of another group with a search through all balls.
#include "simplification/overlapping_balls.h"

#include <gtest/gtest.h>

#include <limits>
#include <random>

namespace medial::test
{
namespace
{

constexpr double kNoLimit = std::numeric_limits<double>::infinity();

/// On a grid of few places, so that many are equally far away.
std::vector<Ball> ballsOnAGrid(int count)
{
  std::mt19937 generator(5);
  std::uniform_int_distribution<int> place(0, 6);
  std::uniform_real_distribution<double> radius(0.1, 1.5);
  std::vector<Ball> balls;
  for (int i = 0; i < count; ++i)
  {
    const glm::dvec3 centre(place(generator), place(generator), place(generator));
    balls.push_back({ centre, radius(generator) });
  }
  return balls;
}

int nearestOfAll(const std::vector<Ball>& balls, const std::vector<int>& groups, int from,
  double limit)
{
  int best = -1;
  for (int i = 0; i < static_cast<int>(balls.size()); ++i)
  {
    const double distance = glm::distance(balls[from].centre, balls[i].centre);
    const double small = std::min(balls[from].radius, balls[i].radius);
    const bool overlap = distance < balls[from].radius + balls[i].radius - 0.05 * small;
    if (groups[i] != groups[from] && overlap &&
      (distance < limit || (distance == limit && best < 0)))
    {
      best = i;
      limit = distance;
    }
  }
  return best;
}

TEST(OverlappingBalls, NearestIsTheFirstOfEquals)
{
  const std::vector<Ball> balls = ballsOnAGrid(400);
  OverlappingBalls others(balls);
  for (const int count : { 2, 7, 400 })
  {
    std::vector<int> groups(balls.size());
    for (std::size_t i = 0; i < groups.size(); ++i)
    {
      // Neighbours in space are often of one group.
      groups[i] = count == 400 ? static_cast<int>(i) : static_cast<int>(balls[i].centre.x) % count;
    }
    others.setGroups(groups);
    for (int from = 0; from < static_cast<int>(balls.size()); ++from)
    {
      for (const double limit : { kNoLimit, 2.0, 1.0 })
      {
        const auto found = others.nearest(balls[from], groups[from], limit);
        const int expected = nearestOfAll(balls, groups, from, limit);
        ASSERT_EQ(found ? found->ball : -1, expected) << count << ' ' << from << ' ' << limit;
        if (found)
        {
          EXPECT_EQ(found->distance, glm::distance(balls[from].centre, balls[expected].centre));
        }
      }
    }
  }
}

TEST(OverlappingBalls, TouchingIsNotOverlapping)
{
  const std::vector<Ball> balls{ { { 0.0, 0.0, 0.0 }, 1.0 }, { { 1.97, 0.0, 0.0 }, 1.0 },
    { { -1.9, 0.0, 0.0 }, 1.0 } };
  OverlappingBalls others(balls);
  EXPECT_FALSE(others.nearest(balls[0], 0, kNoLimit)); // all are of one group
  others.setGroups({ 0, 1, 0 });
  EXPECT_FALSE(others.nearest(balls[0], 0, kNoLimit));
  others.setGroups({ 0, 1, 2 });
  EXPECT_EQ(others.nearest(balls[0], 0, kNoLimit)->ball, 2);
}

TEST(OverlappingBalls, NoneOfNone)
{
  const std::vector<Ball> none;
  EXPECT_FALSE(OverlappingBalls(none).nearest({ {}, 1.0 }, 0, kNoLimit));
}

} // namespace
} // namespace medial::test
