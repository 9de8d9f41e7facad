// Compares distances to hulls of balls with the support function, which does not use touching
// balls.
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

/// Minimum of n . (x - c) - r over some balls.
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

/// The signed distance to a convex body is the maximum over all directions n of n . x - h(n), where
/// h(n) is the maximum of n . c + r over the balls. From inside there are several local maxima, so
/// the search climbs from the best sample of every octant.
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

void expectDistance(const std::vector<Ball>& balls, const HullDistance& found, const glm::dvec3& x)
{
  const double expected = oracle(balls, x);
  EXPECT_GE(found.distance, expected - 1e-9);
  EXPECT_LE(found.distance, expected + 5e-4);
  // The returned ball touches there.
  EXPECT_NEAR(glm::distance(x, found.ball.centre) - found.ball.radius, found.distance, 1e-9);
}

TEST(BallHulls, ConeIsItsSupport)
{
  Random random;
  for (int i = 0; i < 200; ++i)
  {
    const Ball a = random.ball(0.8);
    const Ball b = random.ball(0.8);
    const glm::dvec3 x = 1.5 * random.point();
    expectDistance({ a, b }, distanceToCone(a, b, x), x);
  }
}

TEST(BallHulls, WedgeIsItsSupport)
{
  Random random;
  for (int i = 0; i < 300; ++i)
  {
    const Ball a = random.ball(0.7);
    const Ball b = random.ball(0.7);
    const Ball c = random.ball(0.7);
    const glm::dvec3 x = 1.5 * random.point();
    expectDistance({ a, b, c }, distanceToWedge(a, b, c, x), x);
  }
}

// Deep inside, where the nearest surface is that of a wedge, a cone or a ball.
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
    ASSERT_LT(distanceToWedge(a, b, c, x).distance, -0.49);
    expectDistance({ a, b, c }, distanceToWedge(a, b, c, x), x);
  }
}

TEST(BallHulls, KnownDistances)
{
  const Ball a{ { 0.0, 0.0, 0.0 }, 1.0 };
  const Ball b{ { 4.0, 0.0, 0.0 }, 1.0 };
  const Ball c{ { 0.0, 4.0, 0.0 }, 1.0 };
  EXPECT_DOUBLE_EQ(distanceToCone(a, b, { 2.0, 3.0, 0.0 }).distance, 2.0);
  EXPECT_DOUBLE_EQ(distanceToCone(a, b, { 2.0, 0.0, 0.0 }).distance, -1.0);
  EXPECT_DOUBLE_EQ(distanceToCone(a, b, { 7.0, 0.0, 0.0 }).distance, 2.0);
  EXPECT_DOUBLE_EQ(distanceToWedge(a, b, c, { 1.0, 1.0, 3.0 }).distance, 2.0);
  EXPECT_DOUBLE_EQ(distanceToWedge(a, b, c, { 1.0, 1.0, -0.25 }).distance, -0.75);
  EXPECT_DOUBLE_EQ(distanceToWedge(a, b, c, { 1.0, -3.0, 0.0 }).distance, 2.0);
  // A cone of half angle 30 degrees from its tip.
  const Ball tip{ { 0.0, 0.0, 0.0 }, 0.0 };
  const Ball large{ { 2.0, 0.0, 0.0 }, 1.0 };
  EXPECT_NEAR(distanceToCone(tip, large, { 0.8, 0.0, 0.0 }).distance, -0.4, 1e-15);
  EXPECT_NEAR(distanceToCone(tip, large, { -0.5, 0.0, 0.0 }).distance, 0.5, 1e-15);
}

TEST(BallHulls, DegenerateOnesAreWhatIsLeft)
{
  const Ball large{ { 0.0, 0.0, 0.0 }, 1.0 };
  const Ball within{ { 0.3, 0.0, 0.0 }, 0.5 };
  const Ball same = large;
  const Ball other{ { 2.0, 0.0, 0.0 }, 1.0 };
  const Ball beyond{ { 4.0, 0.0, 0.0 }, 1.0 };
  const glm::dvec3 x{ 1.0, 2.0, 0.5 };
  EXPECT_EQ(distanceToCone(large, within, x).distance, distanceToBall(large, x).distance);
  EXPECT_EQ(distanceToCone(within, large, x).distance, distanceToBall(large, x).distance);
  EXPECT_EQ(distanceToCone(large, same, x).distance, distanceToBall(large, x).distance);
  EXPECT_EQ(distanceToWedge(large, same, same, x).distance, distanceToBall(large, x).distance);
  // A triangle without area, and one whose third ball adds nothing.
  EXPECT_NEAR(distanceToWedge(large, other, beyond, x).distance,
    distanceToCone(large, beyond, x).distance, 1e-15);
  EXPECT_EQ(distanceToWedge(large, other, within, x).distance,
    distanceToCone(large, other, x).distance);
}

TEST(BallHulls, TangentPlanesTouchAllThree)
{
  Random random;
  int existing = 0;
  for (int i = 0; i < 100; ++i)
  {
    const std::vector<Ball> balls{ random.ball(0.4), random.ball(0.4), random.ball(0.4) };
    const auto normals = tangentNormals(balls[0], balls[1], balls[2]);
    if (!normals)
    {
      continue;
    }
    ++existing;
    for (const glm::dvec3& normal : *normals)
    {
      EXPECT_NEAR(glm::length(normal), 1.0, 1e-9);
      const double offset = glm::dot(normal, balls[0].centre) + balls[0].radius;
      EXPECT_NEAR(glm::dot(normal, balls[1].centre) + balls[1].radius, offset, 1e-9);
      EXPECT_NEAR(glm::dot(normal, balls[2].centre) + balls[2].radius, offset, 1e-9);
    }
  }
  EXPECT_GT(existing, 50);
}

glm::dvec4 meanOf(const std::vector<Ball>& balls, const double* shares)
{
  glm::dvec4 mean(0.0);
  for (std::size_t i = 0; i < balls.size(); ++i)
  {
    mean += shares[i] * toVector(balls[i]);
  }
  return mean;
}

/// The distance is that to the ball with these shares.
void expectNearest(const std::vector<Ball>& balls, const double* shares, const HullDistance& found,
  const glm::dvec3& x)
{
  const Ball mean = toBall(meanOf(balls, shares));
  EXPECT_NEAR(distanceToBall(mean, x).distance, found.distance, 1e-12);
  EXPECT_NEAR(glm::distance(toVector(mean), toVector(found.ball)), 0.0, 1e-9);
}

TEST(BallHulls, NearestSharesAreThoseOfTheDistance)
{
  Random random;
  int within = 0;
  for (int i = 0; i < 1000; ++i)
  {
    const std::vector<Ball> balls{ random.ball(0.5), random.ball(0.5), random.ball(0.5) };
    const glm::dvec3 x = 1.5 * random.point();
    const std::vector<Ball> two{ balls[0], balls[1] };
    const auto ofCone = nearestShares(two[0], two[1], x);
    expectNearest(two, ofCone.data(), distanceToCone(two[0], two[1], x), x);
    const auto ofWedge = nearestShares(balls[0], balls[1], balls[2], x);
    if (ofWedge)
    {
      ++within;
      expectNearest(balls, ofWedge->data(), distanceToWedge(balls[0], balls[1], balls[2], x), x);
    }
  }
  EXPECT_GT(within, 50);
}

TEST(BallHulls, WedgesAndConesHaveTheSameTangentPlanes)
{
  Random random;
  int existing = 0;
  for (int i = 0; i < 200; ++i)
  {
    const Ball a = random.ball(0.4);
    const Ball b = random.ball(0.4);
    const Ball c = random.ball(0.4);
    const auto wedge = wedgeOf(a, b, c);
    const auto normals = tangentNormals(a, b, c);
    ASSERT_EQ(wedge.has_value(), normals.has_value());
    if (!wedge)
    {
      continue;
    }
    ++existing;
    EXPECT_NEAR(glm::distance(wedge->normal(1.0), (*normals)[0]), 0.0, 1e-9);
    EXPECT_NEAR(glm::distance(wedge->normal(-1.0), (*normals)[1]), 0.0, 1e-9);
    // Seen along the cone of two of the balls, the planes touch that cone as well.
    const auto cone = coneOf(a, b);
    ASSERT_TRUE(cone);
    EXPECT_NEAR(glm::dot((*normals)[0], cone->axis), cone->slope, 1e-9);
    EXPECT_NEAR(cone->sine * cone->sine + cone->slope * cone->slope, 1.0, 1e-12);
  }
  EXPECT_GT(existing, 100);
}

} // namespace
} // namespace medial::test
