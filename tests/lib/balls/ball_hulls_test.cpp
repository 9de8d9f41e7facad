// Distances to hulls of balls against the support function, which knows nothing of contacts.
#include "balls/ball_hulls.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

namespace medial::test
{
namespace
{

const double kPi = std::acos(-1.0);

std::vector<glm::dvec3> directions(int count)
{
  std::vector<glm::dvec3> result;
  for (int i = 0; i < count; ++i)
  {
    const double z = 1.0 - (2.0 * i + 1.0) / count;
    const double angle = i * kPi * (3.0 - std::sqrt(5.0));
    const double rho = std::sqrt(1.0 - z * z);
    result.emplace_back(rho * std::cos(angle), rho * std::sin(angle), z);
  }
  return result;
}

/// Least of n . (x - c) - r over some balls.
double behind(const std::vector<Ball>& balls, const glm::dvec3& x, const glm::dvec3& n)
{
  double min = 1e30;
  for (const Ball& ball : balls)
  {
    min = std::min(min, glm::dot(n, x - ball.centre) - ball.radius);
  }
  return min;
}

/// Climbs from a direction to one that is farther behind.
double climb(const std::vector<Ball>& balls, const glm::dvec3& x, glm::dvec3 best)
{
  static const std::vector<glm::dvec3> kSteps = directions(300);
  double max = behind(balls, x, best);
  for (double size = 0.1; size > 1e-6; size *= 0.9)
  {
    const glm::dvec3 from = best;
    for (const glm::dvec3& step : kSteps)
    {
      const glm::dvec3 n = glm::normalize(from + size * step);
      const double value = behind(balls, x, n);
      best = value > max ? n : best;
      max = std::max(max, value);
    }
  }
  return max;
}

/// The signed distance to a convex body is the greatest over all directions n of n . x - h(n), with
/// h(n) the greatest n . c + r of the balls. From inside there are several local maxima: climbed
/// from the best sample of every octant.
double oracle(const std::vector<Ball>& balls, const glm::dvec3& x)
{
  static const std::vector<glm::dvec3> kDirections = directions(20000);
  glm::dvec3 starts[8] = {};
  double highest[8];
  std::fill(highest, highest + 8, -1e30);
  for (const glm::dvec3& n : kDirections)
  {
    const int octant = (n.x > 0.0 ? 1 : 0) + (n.y > 0.0 ? 2 : 0) + (n.z > 0.0 ? 4 : 0);
    const double value = behind(balls, x, n);
    starts[octant] = value > highest[octant] ? n : starts[octant];
    highest[octant] = std::max(highest[octant], value);
  }
  double max = -1e30;
  for (const glm::dvec3& start : starts)
  {
    max = std::max(max, climb(balls, x, start));
  }
  return max;
}

class Random
{
public:
  double operator()(double low, double high)
  {
    return std::uniform_real_distribution<double>(low, high)(generator_);
  }
  glm::dvec3 point() { return { (*this)(-1.0, 1.0), (*this)(-1.0, 1.0), (*this)(-1.0, 1.0) }; }
  Ball ball(double most) { return { this->point(), (*this)(0.0, most) }; }

private:
  std::mt19937 generator_{ 7 };
};

void expectDistance(const std::vector<Ball>& balls, const Contact& contact, const glm::dvec3& x)
{
  const double expected = oracle(balls, x);
  EXPECT_GE(contact.distance, expected - 1e-9);
  EXPECT_LE(contact.distance, expected + 5e-4);
  // The ball that is named touches there.
  EXPECT_NEAR(glm::distance(x, contact.ball.centre) - contact.ball.radius, contact.distance, 1e-9);
}

TEST(BallHulls, ConeIsItsSupport)
{
  Random random;
  for (int i = 0; i < 200; ++i)
  {
    const Ball a = random.ball(0.8);
    const Ball b = random.ball(0.8);
    const glm::dvec3 x = 1.5 * random.point();
    expectDistance({ a, b }, contactWithCone(a, b, x), x);
  }
}

TEST(BallHulls, SlabIsItsSupport)
{
  Random random;
  for (int i = 0; i < 300; ++i)
  {
    const Ball a = random.ball(0.7);
    const Ball b = random.ball(0.7);
    const Ball c = random.ball(0.7);
    const glm::dvec3 x = 1.5 * random.point();
    expectDistance({ a, b, c }, contactWithSlab(a, b, c, x), x);
  }
}

// Deep inside, where the nearest surface is that of a slab, a cone or a ball.
TEST(BallHulls, InsideIsExactToo)
{
  Random random;
  for (int i = 0; i < 300; ++i)
  {
    const Ball a{ random.point(), random(0.5, 0.8) };
    const Ball b{ random.point(), random(0.5, 0.8) };
    const Ball c{ random.point(), random(0.5, 0.8) };
    const double u = random(0.0, 1.0);
    const double v = random(0.0, 1.0 - u);
    const glm::dvec3 x = a.centre + u * (b.centre - a.centre) + v * (c.centre - a.centre);
    ASSERT_LT(contactWithSlab(a, b, c, x).distance, -0.49);
    expectDistance({ a, b, c }, contactWithSlab(a, b, c, x), x);
  }
}

TEST(BallHulls, KnownDistances)
{
  const Ball a{ { 0.0, 0.0, 0.0 }, 1.0 };
  const Ball b{ { 4.0, 0.0, 0.0 }, 1.0 };
  const Ball c{ { 0.0, 4.0, 0.0 }, 1.0 };
  EXPECT_DOUBLE_EQ(contactWithCone(a, b, { 2.0, 3.0, 0.0 }).distance, 2.0);
  EXPECT_DOUBLE_EQ(contactWithCone(a, b, { 2.0, 0.0, 0.0 }).distance, -1.0);
  EXPECT_DOUBLE_EQ(contactWithCone(a, b, { 7.0, 0.0, 0.0 }).distance, 2.0);
  EXPECT_DOUBLE_EQ(contactWithSlab(a, b, c, { 1.0, 1.0, 3.0 }).distance, 2.0);
  EXPECT_DOUBLE_EQ(contactWithSlab(a, b, c, { 1.0, 1.0, -0.25 }).distance, -0.75);
  EXPECT_DOUBLE_EQ(contactWithSlab(a, b, c, { 1.0, -3.0, 0.0 }).distance, 2.0);
  // A cone of half angle 30 degrees from its tip.
  const Ball tip{ { 0.0, 0.0, 0.0 }, 0.0 };
  const Ball large{ { 2.0, 0.0, 0.0 }, 1.0 };
  EXPECT_NEAR(contactWithCone(tip, large, { 0.8, 0.0, 0.0 }).distance, -0.4, 1e-15);
  EXPECT_NEAR(contactWithCone(tip, large, { -0.5, 0.0, 0.0 }).distance, 0.5, 1e-15);
}

TEST(BallHulls, DegenerateOnesAreWhatIsLeft)
{
  const Ball large{ { 0.0, 0.0, 0.0 }, 1.0 };
  const Ball within{ { 0.3, 0.0, 0.0 }, 0.5 };
  const Ball same = large;
  const Ball other{ { 2.0, 0.0, 0.0 }, 1.0 };
  const Ball beyond{ { 4.0, 0.0, 0.0 }, 1.0 };
  const glm::dvec3 x{ 1.0, 2.0, 0.5 };
  EXPECT_EQ(contactWithCone(large, within, x).distance, contactWithBall(large, x).distance);
  EXPECT_EQ(contactWithCone(within, large, x).distance, contactWithBall(large, x).distance);
  EXPECT_EQ(contactWithCone(large, same, x).distance, contactWithBall(large, x).distance);
  EXPECT_EQ(contactWithSlab(large, same, same, x).distance, contactWithBall(large, x).distance);
  // A triangle without area, and one whose third ball adds nothing.
  EXPECT_NEAR(contactWithSlab(large, other, beyond, x).distance,
    contactWithCone(large, beyond, x).distance, 1e-15);
  EXPECT_EQ(contactWithSlab(large, other, within, x).distance,
    contactWithCone(large, other, x).distance);
}

TEST(BallHulls, TangentPlanesTouchAllThree)
{
  Random random;
  int existing = 0;
  for (int i = 0; i < 100; ++i)
  {
    const std::vector<Ball> balls{ random.ball(0.4), random.ball(0.4), random.ball(0.4) };
    const TangentPlanes planes = tangentPlanes(balls[0], balls[1], balls[2]);
    existing += planes.exist ? 1 : 0;
    for (const glm::dvec3& normal : planes.normals)
    {
      if (!planes.exist)
      {
        continue;
      }
      EXPECT_NEAR(glm::length(normal), 1.0, 1e-9);
      const double offset = glm::dot(normal, balls[0].centre) + balls[0].radius;
      EXPECT_NEAR(glm::dot(normal, balls[1].centre) + balls[1].radius, offset, 1e-9);
      EXPECT_NEAR(glm::dot(normal, balls[2].centre) + balls[2].radius, offset, 1e-9);
    }
  }
  EXPECT_GT(existing, 50);
}

} // namespace
} // namespace medial::test
