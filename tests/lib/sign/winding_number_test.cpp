#include "sign/winding_number.h"

#include "sign/rim.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <random>
#include <utility>
#include <vector>

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

} // namespace

TEST(WindingNumber, IsOneInsideAndZeroOutside)
{
  const WindingNumber winding(chainOf(torus(1.0, 0.3, 40, 20)));
  const auto expectNear = [&](const glm::dvec3& point, double value)
  {
    const Interval bounds = winding.bounds(point, 1e-5);
    EXPECT_NEAR(bounds.low, value, 1e-2);
    EXPECT_NEAR(bounds.high, value, 1e-2);
  };
  expectNear({ 1.0, 0.0, 0.1 }, 1.0);
  expectNear({ 0.0, 0.0, 0.0 }, 0.0);
  expectNear({ 5.0, 2.0, 1.0 }, 0.0);
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
    }
  }
}

TEST(WindingNumber, BoundsHoldInBalls)
{
  for (const TriangleMesh& mesh : { randomSoup(50, 9), icosphere(1.0, 3) })
  {
    const TriangleChain chain = chainOf(mesh);
    const WindingNumber winding(chain);
    std::mt19937 random(2);
    int bounded = 0;
    for (int i = 0; i < 3000; ++i)
    {
      const double radius = i % 2 == 0 ? 0.02 : 0.3;
      const glm::dvec3 outerCentre = randomPoint(random, 4.0);
      const glm::dvec3 centre = outerCentre + radius * glm::normalize(randomPoint(random, 1.0));
      const WindingNumber::View outer =
        winding.look(winding.everything(), outerCentre, 2.0 * radius, 1e-2);
      const Interval bounds = winding.bounds(winding.look(outer, centre, radius, 1e-2));
      const WindingNumber::View close = winding.lookClosely(outer, centre, radius, 1e-2);
      SolidAngleSums::Points points;
      for (glm::dvec3& point : points)
      {
        point = centre + radius * glm::normalize(randomPoint(random, 1.0));
      }
      const SolidAngleSums::Values values = winding.at(close, points);
      for (int lane = 0; lane < SolidAngleSums::kPoints; ++lane)
      {
        const double exact = sumOf(chain, points[lane]);
        ASSERT_NEAR(values[lane], exact, close.far.error + 1e-12);
        ASSERT_LE(bounds.low, exact + 1e-12);
        ASSERT_GE(bounds.high, exact - 1e-12);
      }
      bounded += bounds.high < HUGE_VAL ? 1 : 0;
    }
    EXPECT_GT(bounded, 500);
  }
}

TEST(WindingNumber, ContinuesThroughLids)
{
  // A wavy loop twice, once with weight 2, and its lids.
  TriangleChain chain;
  std::vector<RimEdge> rim;
  constexpr int kEdges = 40;
  for (int loop = 0; loop < 2; ++loop)
  {
    for (int i = 0; i < kEdges; ++i)
    {
      const double angle = 6.283185307179586 * i / kEdges;
      chain.points.emplace_back(10.0 * std::cos(angle), 10.0 * std::sin(angle),
        0.7 * std::sin(3.0 * angle) + 3.0 * loop);
      rim.push_back({ loop * kEdges + i, loop * kEdges + (i + 1) % kEdges, 1 + loop });
    }
  }
  chain.triangles = lidsOf(rim);
  WindingNumber winding(chain);
  winding.joinTriangles();
  std::mt19937 random(5);
  int certain = 0;
  int behind = 0;
  for (int ball = 0; ball < 400; ++ball)
  {
    const double radius = ball % 2 == 0 ? 0.5 : 2.0;
    const glm::dvec3 centre = randomPoint(random, 1.0) * glm::dvec3(7.0, 7.0, 4.0);
    const WindingNumber::View view =
      winding.lookClosely(winding.everything(), centre, radius, 1e-3);
    const std::optional<Continuation> continuation = winding.continued(view);
    if (!continuation)
    {
      continue;
    }
    Continuation::Points points;
    std::array<glm::dvec3, Continuation::kPoints> positions;
    for (int i = 0; i < Continuation::kPoints; ++i)
    {
      positions[i] = centre + radius * glm::normalize(randomPoint(random, 1.0));
      points.x[i] = positions[i].x;
      points.y[i] = positions[i].y;
      points.z[i] = positions[i].z;
    }
    Continuation::Integers result;
    continuation->round(points, 1e-9, result);
    const double middle = std::floor(sumOf(chain, centre) + 0.5);
    for (int i = 0; i < Continuation::kPoints; ++i)
    {
      if (result.certain[i] != 0.0)
      {
        ASSERT_EQ(result.values[i], std::floor(sumOf(chain, positions[i]) + 0.5));
        ++certain;
        behind += result.values[i] != middle ? 1 : 0;
      }
    }
  }
  EXPECT_GT(certain, 10000);
  EXPECT_GT(behind, 500);
}

TEST(WindingNumber, SumsEightPointsAsOne)
{
  const TriangleChain chain = chainOf(randomSoup(300, 5));
  std::mt19937 random(7);
  for (int i = 0; i < 100; ++i)
  {
    SolidAngleSums::Points points;
    for (glm::dvec3& point : points)
    {
      point = randomPoint(random, 1.5);
    }
    SolidAngleSums sums(points);
    SolidAngleSums::Values exact{};
    for (std::size_t t = 0; t < chain.triangles.size(); ++t)
    {
      const auto corners = chain.cornersOf(chain.triangles[t]);
      const int weight = static_cast<int>(t % 7) - 3;
      sums.add(corners, weight);
      for (int lane = 0; lane < SolidAngleSums::kPoints; ++lane)
      {
        exact[lane] += weight * solidAngle(corners, points[lane]);
      }
    }
    for (int lane = 0; lane < SolidAngleSums::kPoints; ++lane)
    {
      ASSERT_NEAR(sums.at(lane), exact[lane], 1e-12);
    }
  }
}

TEST(LocalExpansion, HasTheDerivativesOfATriangle)
{
  const std::array<glm::dvec3, 3> corners{ glm::dvec3(0.0), { 1.0, 0.2, 0.0 }, { 0.3, 0.9, 0.4 } };
  LocalExpansion expansion;
  expansion.centre = { 0.2, 0.1, 0.8 };
  ExpansionSum sum(expansion.centre);
  sum.addTriangle(corners, 2);
  sum.addTo(expansion);
  constexpr double kStep = 1e-3;
  for (int axis = 0; axis < 3; ++axis)
  {
    glm::dvec3 step(0.0);
    step[axis] = kStep;
    const double before = 2.0 * solidAngle(corners, expansion.centre - step);
    const double after = 2.0 * solidAngle(corners, expansion.centre + step);
    EXPECT_NEAR(expansion.gradient[axis], (after - before) / (2.0 * kStep), 1e-5);
    EXPECT_NEAR(expansion.hessian[axis][axis],
      (after + before - 2.0 * expansion.value) / (kStep * kStep), 1e-4);
  }
}

TEST(LocalExpansion, OfAGroupIsThatOfItsTriangles)
{
  // The same far away, but for terms of third order.
  const TriangleChain chain = chainOf(randomSoup(2, 3));
  Multipole group = Multipole::ofTriangle(chain.cornersOf(chain.triangles[0]), 1);
  group = Multipole::ofBoth(group, Multipole::ofTriangle(chain.cornersOf(chain.triangles[1]), -2));
  for (const double distance : { 50.0, 100.0 })
  {
    LocalExpansion together;
    together.centre = distance * glm::normalize(glm::dvec3(0.3, -0.5, 0.8));
    LocalExpansion apart = together;
    group.addTo(together);
    ExpansionSum sum(apart.centre);
    sum.addTriangle(chain.cornersOf(chain.triangles[0]), 1);
    sum.addTriangle(chain.cornersOf(chain.triangles[1]), -2);
    sum.addTo(apart);
    const double fifth = std::pow(distance, -5.0);
    EXPECT_NEAR(together.value, apart.value, 20.0 * fifth);
    EXPECT_NEAR(glm::distance(together.gradient, apart.gradient), 0.0, 60.0 * fifth);
    EXPECT_NEAR(glm::distance(together.hessian[0], apart.hessian[0]), 0.0, 60.0 * fifth);
  }
}

TEST(Lids, LeaveNoRim)
{
  std::mt19937 random(11);
  for (int run = 0; run < 200; ++run)
  {
    // Edges of random triangles: a rim whose loops meet.
    std::map<std::pair<int, int>, int> nets;
    const auto add = [&](const std::array<int, 3>& corners, int weight)
    {
      for (int i = 0; i < 3; ++i)
      {
        const int from = corners[i];
        const int to = corners[(i + 1) % 3];
        nets[std::minmax(from, to)] += from < to ? weight : -weight;
      }
    };
    for (int i = 0; i < 20; ++i)
    {
      const int first = static_cast<int>(random() % 10);
      add({ first, first + 1 + static_cast<int>(random() % 3), first + 5 }, 1 + i % 2);
    }
    std::vector<RimEdge> rim;
    for (const auto& [edge, net] : nets)
    {
      if (net != 0)
      {
        rim.push_back(net > 0 ? RimEdge{ edge.first, edge.second, net }
                              : RimEdge{ edge.second, edge.first, -net });
      }
    }
    for (const WeightedTriangle& lid : lidsOf(rim))
    {
      add(lid.corners, lid.weight);
    }
    for (const auto& [edge, net] : nets)
    {
      ASSERT_EQ(net, 0);
    }
  }
}

TEST(Lids, AreAsManyAsConnectedPieces)
{
  EXPECT_EQ(countHoles({}), 0);
  EXPECT_EQ(countHoles({ { 0, 1, 1 }, { 1, 2, 1 }, { 2, 0, 1 } }), 1);
  EXPECT_EQ(
    countHoles({ { 5, 6, 1 }, { 6, 7, 1 }, { 7, 5, 1 }, { 0, 1, 2 }, { 1, 2, 2 }, { 2, 0, 2 } }),
    2);
  EXPECT_EQ(lidsOf({ { 0, 1, 1 }, { 1, 2, 1 }, { 2, 0, 1 } }).size(), 1U);
}
