#include "sign/winding_number.h"

#include "sign/lids.h"
#include "sign/rim_bound.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

using namespace medial;
using namespace medial::test;

namespace
{

TriangleChain chainOf(const TriangleMesh& mesh)
{
  TriangleChain chain;
  for (const Point3& p : mesh.points)
  {
    chain.points.emplace_back(p[0], p[1], p[2]);
  }
  for (const auto& triangle : mesh.triangles)
  {
    chain.triangles.push_back({ triangle, 1 });
  }
  return chain;
}

double sumOf(const TriangleChain& chain, const glm::dvec3& point)
{
  double sum = 0.0;
  for (const WeightedTriangle& triangle : chain.triangles)
  {
    sum += triangle.weight * solidAngle(chain.cornersOf(triangle), point);
  }
  return sum;
}

glm::dvec3 randomPoint(std::mt19937& random, double reach)
{
  std::uniform_real_distribution<double> coordinate(-reach, reach);
  const double x = coordinate(random);
  const double y = coordinate(random);
  return { x, y, coordinate(random) };
}

/// A fan over a wavy ring, as lids are.
TriangleChain wavyLid(int corners)
{
  TriangleChain chain;
  for (int i = 0; i < corners; ++i)
  {
    const double angle = 2.0 * std::acos(-1.0) * i / corners;
    chain.points.emplace_back(std::cos(angle), std::sin(angle), 0.2 * std::sin(3.0 * angle));
    chain.triangles.push_back({ { i, (i + 1) % corners, corners }, 1 });
  }
  chain.points.emplace_back(0.1, 0.0, 0.05);
  return chain;
}

} // namespace

TEST(WindingNumber, IsOneInsideAndZeroOutside)
{
  const WindingNumber winding(chainOf(torus(1.0, 0.3, 40, 20)));
  EXPECT_NEAR(winding.at({ 1.0, 0.0, 0.1 }, 1e-3), 1.0, 1e-3);
  EXPECT_NEAR(winding.at({ 0.0, 0.0, 0.0 }, 1e-3), 0.0, 1e-3);
  EXPECT_NEAR(winding.at({ 5.0, 2.0, 1.0 }, 1e-3), 0.0, 1e-3);
}

TEST(WindingNumber, BoundsHold)
{
  for (const TriangleMesh& mesh : { randomSoup(200, 4), icosphere(1.0, 3) })
  {
    const TriangleChain chain = chainOf(mesh);
    const WindingNumber winding(chain);
    std::mt19937 random(1);
    for (int i = 0; i < 2000; ++i)
    {
      const glm::dvec3 point = randomPoint(random, 3.0);
      const double exact = sumOf(chain, point);
      for (const double tolerance : { 1e-1, 1e-2, 1e-4, 0.0 })
      {
        const Interval bounds = winding.bounds(point, tolerance);
        ASSERT_LE(bounds.low, exact + 1e-12);
        ASSERT_GE(bounds.high, exact - 1e-12);
      }
      ASSERT_NEAR(winding.at(point, 1e-3), exact, 1.001e-3);
    }
  }
}

TEST(WindingNumber, AffineBoundHoldsInTheBall)
{
  const TriangleChain chain = chainOf(randomSoup(50, 9));
  const WindingNumber winding(chain);
  std::mt19937 random(2);
  int far = 0;
  for (int i = 0; i < 3000; ++i)
  {
    AffineBound bound;
    bound.centre = randomPoint(random, 20.0);
    bound.radius = 1.5;
    if (winding.addDipole(0.05, bound))
    {
      ++far;
      const glm::dvec3 point =
        bound.centre + bound.radius * glm::normalize(randomPoint(random, 1.0));
      ASSERT_NEAR(bound.at(point), sumOf(chain, point), bound.error);
    }
  }
  EXPECT_GT(far, 100);
}

TEST(RimBound, HoldsForTheGradientOfALid)
{
  const TriangleChain lid = wavyLid(24);
  const RimBound rim(lid);
  std::mt19937 random(5);
  constexpr double kStep = 1e-4;
  int checked = 0;
  for (int i = 0; i < 2000; ++i)
  {
    const glm::dvec3 centre = randomPoint(random, 2.0);
    const double radius = 0.1;
    const double max = rim.maxGradient(centre, radius);
    const glm::dvec3 point = centre + 0.9 * radius * glm::normalize(randomPoint(random, 1.0));
    const glm::dvec3 step = kStep * glm::normalize(randomPoint(random, 1.0));
    double change = sumOf(lid, point + step) - sumOf(lid, point);
    change -= std::round(change); // the jump at the lid
    if (max < HUGE_VAL)
    {
      ++checked;
      ASSERT_LE(std::abs(change), max * kStep * 1.001 + 1e-12);
    }
  }
  EXPECT_GT(checked, 1000);
}
