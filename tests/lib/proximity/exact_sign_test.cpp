// Signs of determinants against integers, where double precision alone would fail.
#include "base/exact_sign.h"

#include "lib/proximity/integers.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>
#include <random>
#include <utility>

namespace medial::test
{
namespace
{

using Points = std::array<glm::dvec3, 4>;

int orientationOf(const Points& points)
{
  return orientation(points[0], points[1], points[2], points[3]);
}

int exactSideOf(const Points& points, int exponent)
{
  return exactSide(multiples(points[0], exponent), multiples(points[1], exponent),
    multiples(points[2], exponent), multiples(points[3], exponent));
}

int signOf(double value)
{
  return (value > 0.0) - (value < 0.0);
}

/// Every way to the sign leads to the expected one.
void expectSign(int expected, const Points& points)
{
  ASSERT_EQ(orientationOf(points), expected);
  ASSERT_EQ(exact::orientation(points[0], points[1], points[2], points[3]), expected);
  ASSERT_EQ(signOf(exact::determinant(points[0], points[1], points[2], points[3])), expected);
}

Points latticePoints(std::mt19937& random, int size)
{
  std::uniform_int_distribution<int> coordinate(0, size - 1);
  Points points;
  for (glm::dvec3& point : points)
  {
    point = { coordinate(random), coordinate(random), coordinate(random) };
  }
  return points;
}

TEST(ExactSign, IsNegativeBeforeThePlaneOfCounterclockwisePoints)
{
  const glm::dvec3 a(0.0), b(1.0, 0.0, 0.0), c(0.0, 1.0, 0.0);
  EXPECT_EQ(orientation(a, b, c, { 0.2, 0.2, 1.0 }), -1);
  EXPECT_EQ(orientation(a, b, c, { 0.2, 0.2, -1.0 }), 1);
  EXPECT_EQ(orientation(a, b, c, { 7.0, -3.0, 0.0 }), 0);
  EXPECT_EQ(orientation(glm::dvec2(a), glm::dvec2(b), glm::dvec2(c)), 1);
  EXPECT_EQ(orientation(glm::dvec2(b), glm::dvec2(a), glm::dvec2(c)), -1);
  EXPECT_EQ(orientation(glm::dvec2(a), glm::dvec2(b), glm::dvec2(0.5, 0.0)), 0);
}

TEST(ExactSign, OfPointsOfALattice)
{
  std::mt19937 random(1);
  int coplanar = 0;
  for (int i = 0; i < 100000; ++i)
  {
    const Points points = latticePoints(random, 5);
    const int expected = exactSideOf(points, 0);
    coplanar += expected == 0 ? 1 : 0;
    ASSERT_NO_FATAL_FAILURE(expectSign(expected, points));
  }
  EXPECT_GT(coplanar, 5000);
}

Points scaled(Points points, const glm::dvec3& factors)
{
  for (glm::dvec3& point : points)
  {
    point *= factors;
  }
  return points;
}

/// Points of a lattice that is rounded to multiples of 2^kRoundedExponent.
Points rounded(Points points)
{
  for (glm::dvec3& point : points)
  {
    point = 0.1 * point + 1e6;
  }
  return points;
}

constexpr int kRoundedExponent = -33;

TEST(ExactSign, OfPointsOfALatticeThatAreRounded)
{
  std::mt19937 random(2);
  int changed = 0;
  for (int i = 0; i < 100000; ++i)
  {
    const Points lattice = latticePoints(random, 5);
    const Points points = rounded(lattice);
    const int expected = exactSideOf(points, kRoundedExponent);
    changed += exactSideOf(lattice, 0) == 0 && expected != 0 ? 1 : 0;
    ASSERT_NO_FATAL_FAILURE(expectSign(expected, points));
  }
  EXPECT_GT(changed, 1000); // what the lattice has in a plane is not in one any more
}

TEST(ExactSign, OfPointsOfALatticeWithEdgesOfAnyLength)
{
  std::mt19937 random(3);
  std::uniform_int_distribution<int> exponent(-59, 59);
  for (int i = 0; i < 100000; ++i)
  {
    const Points points = latticePoints(random, 9);
    const glm::dvec3 factors(std::ldexp(1.0, exponent(random)), std::ldexp(1.0, exponent(random)),
      std::ldexp(1.0, exponent(random)));
    ASSERT_NO_FATAL_FAILURE(expectSign(exactSideOf(points, 0), scaled(points, factors)));
  }
}

TEST(ExactSign, OfDifferencesThatNeedTwoDoubles)
{
  const glm::dvec3 a(1e18, 0.0, 0.0), b(0.0, 1e18, 0.0), c(0.0, 0.0, 1e18);
  const glm::dvec3 inPlane(5e17, 5e17, 0.0);
  EXPECT_EQ(orientation(a, b, c, inPlane), 0);
  EXPECT_EQ(orientation(a, b, c, inPlane + glm::dvec3(0.0, 0.0, 1e-18)), -1);
  EXPECT_EQ(orientation(a, b, c, inPlane - glm::dvec3(0.0, 0.0, 1e-18)), 1);
  const glm::dvec2 p(1e18, 0.0), q(-1e18, 0.0);
  EXPECT_EQ(orientation(p, q, { 3.0, 0.0 }), 0);
  EXPECT_EQ(orientation(p, q, { 3.0, 1e-18 }), -1);
  EXPECT_EQ(orientation(p, q, { 3.0, -1e-18 }), 1);
}

TEST(ExactSign, AtTheEndsOfTheRangeOfCoordinates)
{
  std::mt19937 random(4);
  for (int i = 0; i < 10000; ++i)
  {
    const Points points = rounded(latticePoints(random, 5));
    const int expected = exactSideOf(points, kRoundedExponent);
    ASSERT_NO_FATAL_FAILURE(expectSign(expected, scaled(points, glm::dvec3(0x1p-250))));
    ASSERT_NO_FATAL_FAILURE(expectSign(expected, scaled(points, glm::dvec3(0x1p312))));
  }
}

/// Shewchuk's example: points next to (0.5, 0.5) beside the line through (12, 12) and (24, 24).
void forEachNearDiagonal(const std::function<void(const glm::dvec2& point, int expected)>& visit)
{
  const double step = std::ldexp(1.0, -53);
  for (int i = 0; i < 256; ++i)
  {
    for (int j = 0; j < 256; ++j)
    {
      // Numbers from 0.5 on are multiples of the step.
      visit({ 0.5 + i * step, 0.5 + j * step }, (j > i) - (j < i));
    }
  }
}

TEST(ExactSign, OfNearlyCollinearPoints)
{
  forEachNearDiagonal(
    [](const glm::dvec2& point, int expected)
    {
      const glm::dvec2 q(12.0), r(24.0);
      ASSERT_EQ(orientation(point, q, r), expected);
      ASSERT_EQ(orientation(q, r, point), expected);
      ASSERT_EQ(orientation(r, q, point), -expected);
      ASSERT_EQ(exact::orientation(q, r, point), expected);
    });
}

TEST(ExactSign, OfNearlyCoplanarPoints)
{
  const Points wall{ { { 12.0, 12.0, 1.0 }, { 24.0, 24.0, -7.0 }, { 24.0, 24.0, 5.0 }, {} } };
  forEachNearDiagonal(
    [&](const glm::dvec2& point, int expected)
    {
      Points points = wall;
      points[3] = { point, 0.5 };
      for (const double factor : { 1.0, 0x1p-231, 0x1p327 }) // to the ends of the range
      {
        ASSERT_NO_FATAL_FAILURE(expectSign(expected, scaled(points, glm::dvec3(factor))));
      }
    });
}

TEST(ExactSign, IsAntisymmetric)
{
  std::mt19937 random(5);
  std::uniform_real_distribution<double> coordinate(-1.0, 1.0);
  for (int i = 0; i < 20000; ++i)
  {
    Points points;
    for (glm::dvec3& point : points)
    {
      point = { coordinate(random), coordinate(random), coordinate(random) };
    }
    // In the plane of the others but for rounding.
    points[3] = points[0] + coordinate(random) * (points[1] - points[0]) +
      coordinate(random) * (points[2] - points[0]);
    const int sign = orientationOf(points);
    for (int j = 0; j < 4; ++j)
    {
      for (int k = j + 1; k < 4; ++k)
      {
        Points swapped = points;
        std::swap(swapped[j], swapped[k]);
        ASSERT_NO_FATAL_FAILURE(expectSign(-sign, swapped));
      }
    }
  }
}

TEST(ExactSign, OfADeterminantThatCancels)
{
  const double tiny = std::ldexp(1.0, -60);
  const glm::dvec3 a(1.0, 0.0, 0.0), b(0.0, 1.0, 0.0), c(0.0, 0.0, 1.0);
  EXPECT_EQ(exact::determinant(a, b, c, glm::dvec3(0.0)), 1.0);
  // 1 - x - y - z
  EXPECT_EQ(exact::determinant(a, b, c, { 0.5, 0.5, tiny }), -tiny);
  EXPECT_EQ(exact::determinant(a, b, c, { 0.5, 0.5, -3.0 * tiny }), 3.0 * tiny);
}

} // namespace
} // namespace medial::test
