#include "axis/widest_place.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

namespace medial
{
namespace
{

const glm::dvec3 kAlong(0.6, 0.0, 0.8);
const std::array<glm::dvec3, 2> kAcross = normalsTo(kAlong);

glm::dvec3 at(double u, double v)
{
  return u * kAcross[0] + v * kAcross[1];
}

double distanceTo(const glm::dvec3& x, double u, double v)
{
  return std::hypot(glm::dot(x, kAcross[0]) - u, glm::dot(x, kAcross[1]) - v);
}

/// A wall: the points with dot(normal, x) = distance in the cross-section.
struct Wall
{
  double angle;
  double distance;

  glm::dvec3 normal() const { return at(std::cos(angle), std::sin(angle)); }
  double from(const glm::dvec3& x) const { return distance - glm::dot(this->normal(), x); }
};

/// Closest points within convex walls.
struct Prism
{
  std::vector<Wall> walls;
  mutable int asked = 0;

  glm::dvec3 operator()(const glm::dvec3& x) const
  {
    ++asked;
    const Wall& nearest = *std::min_element(walls.begin(), walls.end(),
      [&](const Wall& a, const Wall& b) { return a.from(x) < b.from(x); });
    return x + nearest.from(x) * nearest.normal();
  }
};

TEST(WidestPlace, OfATubeIsItsCentre)
{
  constexpr double kRadius = 3.0;
  int most = 0;
  for (int i = 0; i < 36; ++i)
  {
    int asked = 0;
    const auto closest = [&](const glm::dvec3& x)
    {
      ++asked;
      const glm::dvec3 along = glm::dot(x, kAlong) * kAlong;
      const double off = glm::distance(x, along);
      const glm::dvec3 out = off > 0.0 ? (x - along) / off : kAcross[0];
      return along + kRadius * out;
    };
    const double angle = glm::radians(10.0 * i);
    const double off = 0.035 * i;
    const glm::dvec3 x = at(off * std::cos(angle), off * std::sin(angle)) + 2.0 * kAlong;
    const glm::dvec3 place = widestPlace(x, kAlong, 0.005, closest);
    EXPECT_LE(distanceTo(place, 0.0, 0.0), 0.005) << i;
    EXPECT_NEAR(glm::dot(place, kAlong), 2.0, 1e-12) << i;
    most = std::max(most, asked);
  }
  EXPECT_LE(most, 9);
}

TEST(WidestPlace, OfAPrismIsTheCentreOfItsLargestCircle)
{
  std::mt19937 random(1);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  for (const int sides : { 3, 4, 7, 24, 64 })
  {
    for (int round = 0; round < 20; ++round)
    {
      const double u = 5.0 * uniform(random);
      const double v = 5.0 * uniform(random);
      const double turn = uniform(random);
      Prism prism;
      for (int k = 0; k < sides; ++k)
      {
        const double angle = turn + glm::radians(360.0) * k / sides;
        prism.walls.push_back({ angle, 2.0 + u * std::cos(angle) + v * std::sin(angle) });
      }
      const glm::dvec3 x = at(u + 0.6 * uniform(random), v + 0.6 * uniform(random));
      const glm::dvec3 place = widestPlace(x, kAlong, 0.01, prism);
      EXPECT_LE(distanceTo(place, u, v), 0.02) << sides << " sides, round " << round;
      EXPECT_LE(prism.asked, 16);
    }
  }
}

TEST(WidestPlace, BetweenWallsIsTheMiddleBesideThePoint)
{
  const Prism walls{ { { 0.3, 1.0 }, { 0.3 + glm::radians(180.0), 1.0 } } };
  const glm::dvec3 along = at(-std::sin(0.3), std::cos(0.3));
  for (const double off : { -0.45, -0.1, 0.0, 0.4 })
  {
    const glm::dvec3 middle = 1.7 * along;
    const glm::dvec3 place =
      widestPlace(middle + off * walls.walls[0].normal(), kAlong, 0.005, walls);
    EXPECT_LE(glm::distance(place, middle), 0.005) << off;
  }
}

TEST(WidestPlace, IsNeverNarrowerThanThePoint)
{
  std::mt19937 random(2);
  std::uniform_real_distribution<double> uniform(-4.0, 4.0);
  for (int round = 0; round < 200; ++round)
  {
    std::vector<glm::dvec3> points;
    for (int i = 0; i < 30; ++i)
    {
      points.push_back(at(uniform(random), uniform(random)) + uniform(random) * kAlong);
    }
    const auto closest = [&](const glm::dvec3& x)
    {
      return *std::min_element(points.begin(), points.end(),
        [&](const glm::dvec3& a, const glm::dvec3& b)
        { return glm::distance(a, x) < glm::distance(b, x); });
    };
    const glm::dvec3 x = at(uniform(random), uniform(random));
    const glm::dvec3 place = widestPlace(x, kAlong, 0.01, closest);
    EXPECT_GE(glm::distance(closest(place), place), glm::distance(closest(x), x)) << round;
    EXPECT_LE(glm::distance(place, x), glm::distance(closest(x), x) * (1.0 + 1e-12)) << round;
  }
}

TEST(WidestPlace, StaysWhereThereIsNoCrossSection)
{
  const Prism walls{ { { 0.0, 1.0 } } };
  const glm::dvec3 x = at(0.5, 0.25);
  EXPECT_EQ(widestPlace(x, glm::dvec3(0.0), 0.01, walls), x);
}

} // namespace
} // namespace medial
