// Tiles of local thickness against balls that are tried one by one.
#include "thickness/thickness_tile.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <random>
#include <vector>

using namespace medial;

namespace
{

constexpr int kSide = ThicknessTile::kSide;
constexpr double kAngle = 0.4; ///< radians
/// By how much balls are smaller or larger for the least and the largest radius that may be right.
constexpr float kSlack = 0.02f;

using Ball = glm::vec4;

/// Balls along a bent strip of quads, below the tile or through it.
struct Strip
{
  std::vector<Ball> balls;
  std::vector<std::array<std::uint32_t, 4>> quads;
};

Strip strip(unsigned seed, int length, float radius)
{
  std::mt19937 random(seed);
  std::uniform_real_distribution<float> noise(-0.3f, 0.3f);
  Strip made;
  for (int i = 0; i < length; ++i)
  {
    for (int j = 0; j < length; ++j)
    {
      const auto x = static_cast<float>(i);
      const auto y = static_cast<float>(j);
      made.balls.emplace_back(x + noise(random), y + noise(random), 4.0f - 0.3f * x + noise(random),
        radius + 0.1f * (x - y) + 0.3f * noise(random));
    }
  }
  for (int i = 0; i + 1 < length; ++i)
  {
    for (int j = 0; j + 1 < length; ++j)
    {
      const auto first = static_cast<std::uint32_t>(i * length + j);
      const auto across = static_cast<std::uint32_t>(length);
      made.quads.push_back({ first, first + 1, first + across + 1, first + across });
    }
  }
  return made;
}

BallFamilies familiesOf(const Strip& strip, const Point3& spacing = { 1.0, 1.0, 1.0 })
{
  Grid grid;
  grid.spacing = spacing;
  grid.dimensions = { kSide, kSide, kSide };
  BallFamilies families(grid, kAngle);
  for (const Ball& ball : strip.balls)
  {
    families.add(glm::vec3(ball), ball.w);
  }
  for (const auto& quad : strip.quads)
  {
    families.joinQuad(quad);
  }
  families.finish();
  return families;
}

glm::vec3 pointOf(const BallFamilies& families, int index)
{
  return glm::vec3(ThicknessTile::place(index)) * families.step();
}

/// Largest radius of many balls of the triangles that contain a point.
/// @param grown by how much balls are larger for this.
float largestOf(const BallFamilies& families, const glm::vec3& point, float stretch, float grown)
{
  constexpr int kParts = 20;
  float largest = 0.0f;
  const auto tryTriangle = [&](const Ball& a, const Ball& b, const Ball& c)
  {
    for (int u = 0; u <= kParts; ++u)
    {
      for (int v = 0; u + v <= kParts; ++v)
      {
        const float first = static_cast<float>(u) / kParts;
        const float second = static_cast<float>(v) / kParts;
        const Ball ball = first * a + second * b + (1.0f - first - second) * c;
        if (glm::distance(glm::vec3(ball), point) <= ball.w * stretch + grown)
        {
          largest = std::max(largest, ball.w);
        }
      }
    }
  };
  for (std::uint32_t number = 0; number < families.itemCount(); ++number)
  {
    const BallFamilies::Item& item = families.item(number);
    for (std::uint32_t t = item.trianglesBegin; t < families.item(number + 1).trianglesBegin; ++t)
    {
      const auto& [second, third] = families.triangleEnds()[t];
      tryTriangle(families.ball(item.ball), families.ball(second), families.ball(third));
    }
  }
  return largest;
}

class Tiles : public testing::TestWithParam<unsigned>
{
protected:
  const BallFamilies families_ = familiesOf(strip(GetParam(), 9, GetParam() % 2 == 0 ? 2.0f : 5.0f),
    GetParam() <= 4 ? Point3{ 1.0, 1.0, 1.0 } : Point3{ 1.3, 1.0, 1.6 });
};

} // namespace

TEST_P(Tiles, HaveTheLargestBallAroundEveryPoint)
{
  for (const float stretch : { 1.0f, families_.stretch() })
  {
    ThicknessTile tile(families_, glm::vec3(0.0f));
    for (int point = 0; point < ThicknessTile::kPoints; ++point)
    {
      tile.set(point, 0.0f);
    }
    tile.raise(stretch);
    int contained = 0;
    for (int point = 0; point < ThicknessTile::kPoints; point += 5)
    {
      const float radius = tile.radius(point);
      EXPECT_GE(radius, largestOf(families_, pointOf(families_, point), stretch, -kSlack) - 0.002f);
      EXPECT_LE(radius, largestOf(families_, pointOf(families_, point), stretch, kSlack) + 0.03f);
      contained += radius > 0.0f ? 1 : 0;
    }
    EXPECT_GT(contained, 20);
  }
}

TEST(ThicknessTile, NumbersEachPlaceOnce)
{
  std::vector<int> seen(ThicknessTile::kPoints, 0);
  for (int point = 0; point < ThicknessTile::kPoints; ++point)
  {
    const glm::ivec3 place = ThicknessTile::place(point);
    ASSERT_TRUE(glm::all(glm::lessThan(place, glm::ivec3(kSide))));
    EXPECT_EQ(ThicknessTile::index(place), point);
    ++seen[(place.z * kSide + place.y) * kSide + place.x];
  }
  EXPECT_EQ(std::count(seen.begin(), seen.end(), 1), ThicknessTile::kPoints);
}

TEST(ThicknessTile, RaisesTheSliceOfAPointAlone)
{
  const BallFamilies families = familiesOf(strip(1, 3, 2.0f));
  ThicknessTile tile(families, glm::vec3(0.0f));
  for (int point = 0; point < ThicknessTile::kPoints; ++point)
  {
    tile.set(point, 0.0f);
  }
  tile.raise(glm::vec3(4.0f), 2.1f, 5);
  for (int point = 0; point < ThicknessTile::kPoints; ++point)
  {
    const glm::vec3 place = pointOf(families, point);
    const bool isIn = place.z == 5.0f && glm::distance(place, glm::vec3(4.0f)) <= 2.1f;
    EXPECT_NEAR(tile.radius(point), isIn ? 2.1f : 0.0f, 0.002f) << point;
  }
}

TEST_P(Tiles, DoNotDependOnWhichPointsAreWanted)
{
  std::mt19937 random(GetParam());
  ThicknessTile whole(families_, glm::vec3(0.0f));
  ThicknessTile some(families_, glm::vec3(0.0f));
  std::vector<int> wanted;
  for (int point = 0; point < ThicknessTile::kPoints; ++point)
  {
    whole.set(point, 0.0f);
    if (random() % 5 == 0)
    {
      some.set(point, 0.0f);
      wanted.push_back(point);
    }
  }
  whole.raise();
  some.raise();
  for (const int point : wanted)
  {
    EXPECT_EQ(some.radius(point), whole.radius(point));
  }
}

INSTANTIATE_TEST_SUITE_P(Strips, Tiles, testing::Values(1u, 2u, 3u, 4u, 5u, 6u));

TEST(BallFamilies, EqualBallsAreMerged)
{
  Strip twice = strip(1, 3, 2.0f);
  const Strip once = twice;
  const auto count = static_cast<std::uint32_t>(once.balls.size());
  twice.balls.insert(twice.balls.end(), once.balls.begin(), once.balls.end());
  for (const auto& [a, b, c, d] : once.quads)
  {
    twice.quads.push_back({ count + a, count + b, count + c, count + d });
  }
  const BallFamilies merged = familiesOf(twice);
  const BallFamilies expected = familiesOf(once);
  EXPECT_EQ(merged.size(), once.balls.size());
  EXPECT_EQ(merged.edgeEnds(), expected.edgeEnds());
  EXPECT_EQ(merged.triangleEnds(), expected.triangleEnds());
}
