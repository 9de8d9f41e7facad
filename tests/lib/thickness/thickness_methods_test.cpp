// The three kinds of thickness, of shapes for which they are known in closed form.
#include "medial/thickness.h"

#include "support/medial_truth.h"
#include "support/shapes.h"
#include "support/thickness_shapes.h"
#include "support/transforms.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

using namespace medial;
using namespace medial::test;

namespace
{

/// The tolerance of single precision, relative to values about 1.
constexpr double kRounding = 1e-6;
const double kDegree = std::acos(-1.0) / 180.0;

Thickness thicknessOf(const TriangleMesh& mesh, ThicknessMethod method, Side side = Side::Interior)
{
  ThicknessOptions options;
  options.method = method;
  options.side = side;
  options.cells = true;
  return computeThickness(mesh, options);
}

Point3 centreOf(const TriangleMesh& mesh, std::size_t triangle)
{
  Point3 centre{};
  for (const int corner : mesh.triangles[triangle])
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      centre[axis] += mesh.points[corner][axis] / 3.0;
    }
  }
  return centre;
}

/// Calls visit(place, value) for all points and all centres of triangles.
template <typename Visit>
void visitAll(const TriangleMesh& mesh, const Thickness& thickness, const Visit& visit)
{
  ASSERT_EQ(thickness.values.size(), mesh.points.size());
  ASSERT_EQ(thickness.triangleValues.size(), mesh.triangles.size());
  for (std::size_t i = 0; i < mesh.points.size(); ++i)
  {
    visit(mesh.points[i], static_cast<double>(thickness.values[i]));
  }
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
  {
    visit(centreOf(mesh, i), static_cast<double>(thickness.triangleValues[i]));
  }
}

void expectAll(const TriangleMesh& mesh, ThicknessMethod method, double value, double tolerance)
{
  visitAll(mesh, thicknessOf(mesh, method),
    [&](const Point3& x, double found)
    { EXPECT_NEAR(found, value, tolerance) << x[0] << " " << x[1] << " " << x[2]; });
}

/// The side of the box that a point is on: its axis, or -1 on edges.
int sideOf(const Point3& halfSides, const Point3& x)
{
  int found = -1;
  for (int axis = 0; axis < 3; ++axis)
  {
    if (std::abs(x[axis]) > halfSides[axis] - 1e-9)
    {
      if (found >= 0)
      {
        return -1;
      }
      found = axis;
    }
  }
  return found;
}

const Point3 kBox{ 2.0, 1.0, 0.5 };

} // namespace

TEST(ThicknessMethods, OfPlatesAreAllTheirGap)
{
  const TriangleMesh mesh = tilted(subdivided(plates(0.37, 1.0), 2));
  for (const ThicknessMethod method :
    { ThicknessMethod::Ball, ThicknessMethod::Ray, ThicknessMethod::Wall })
  {
    expectAll(mesh, method, 0.37, kRounding);
  }
}

TEST(ThicknessMethods, RayOfABoxIsTheDistanceToTheOppositeSide)
{
  const TriangleMesh mesh = subdivided(box(kBox), 3);
  for (const TriangleMesh& turned : { mesh, translated(mesh, { 100.0, -30.0, 7.0 }) })
  {
    const Thickness thickness = thicknessOf(turned, ThicknessMethod::Ray);
    for (std::size_t i = 0; i < mesh.points.size(); ++i)
    {
      const int side = sideOf(kBox, mesh.points[i]);
      if (side >= 0)
      {
        ASSERT_NEAR(thickness.values[i], 2.0 * kBox[side], 4e-6);
      }
    }
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
    {
      ASSERT_NEAR(thickness.triangleValues[i], 2.0 * kBox[sideOf(kBox, centreOf(mesh, i))], 4e-6);
    }
  }
}

// On an edge it is the least of what the faces have beside it.
TEST(ThicknessMethods, RayOnSharpEdgesIsThatOfTheFacesThere)
{
  const TriangleMesh mesh = subdivided(box(kBox), 2);
  const Thickness thickness = thicknessOf(mesh, ThicknessMethod::Ray);
  for (std::size_t i = 0; i < mesh.points.size(); ++i)
  {
    double least = HUGE_VAL;
    for (int axis = 0; axis < 3; ++axis)
    {
      const bool on = std::abs(mesh.points[i][axis]) > kBox[axis] - 1e-9;
      least = on ? std::min(least, 2.0 * kBox[axis]) : least;
    }
    ASSERT_NEAR(thickness.values[i], least, kRounding);
  }
}

TEST(ThicknessMethods, WallOfABoxIsItsHeightEverywhere)
{
  expectAll(subdivided(box(kBox), 4), ThicknessMethod::Wall, 1.0, kRounding);
  expectAll(tilted(subdivided(box(kBox), 3)), ThicknessMethod::Wall, 1.0, kRounding);
  // The centres of its twelve triangles are enough.
  expectAll(box(kBox), ThicknessMethod::Wall, 1.0, kRounding);
}

TEST(ThicknessMethods, OfAWedge)
{
  constexpr double kWidth = 1.0;
  const TriangleMesh mesh = subdivided(wedge(30.0, 4.0, kWidth), 4);
  const double half = std::tan(15.0 * kDegree);
  const double last = kWidth * (1.0 - std::sin(15.0 * kDegree)); // of the balls between its sides
  const auto alongSide = [](const Point3& x) { return std::hypot(x[0], x[1]); };
  const auto onSide = [&](const Point3& x)
  {
    const double angle = std::abs(std::atan2(x[1], x[0]));
    return std::abs(x[2]) < 1.0 && std::abs(angle - 15.0 * kDegree) < 1e-9;
  };
  int sides = 0;
  visitAll(mesh, thicknessOf(mesh, ThicknessMethod::Ray),
    [&](const Point3& x, double value)
    {
      if (onSide(x) && alongSide(x) < 0.8)
      {
        ++sides;
        ASSERT_NEAR(value, std::tan(30.0 * kDegree) * alongSide(x), 3e-6);
      }
    });
  EXPECT_GE(sides, 100);
  visitAll(mesh, thicknessOf(mesh, ThicknessMethod::Wall),
    [&](const Point3& x, double value)
    {
      if (onSide(x) && alongSide(x) < 0.99 * last)
      {
        ASSERT_NEAR(value, 2.0 * half * alongSide(x), 3e-6);
      }
      else if (onSide(x)) // beside the back, where balls touch two sides at 105 degrees only
      {
        ASSERT_NEAR(value, 2.0 * half * last, 0.1);
      }
    });
}

TEST(ThicknessMethods, OfABallAreItsDiameter)
{
  for (const ThicknessMethod method : { ThicknessMethod::Ray, ThicknessMethod::Wall })
  {
    expectAll(icosphere(1.0, 3), method, 2.0, 0.04);
  }
}

TEST(ThicknessMethods, OfATubeAreTheDifferenceOfItsRadii)
{
  const TriangleMesh mesh = tube(0.8, 1.0, 2.0, 96);
  for (const ThicknessMethod method : { ThicknessMethod::Ray, ThicknessMethod::Wall })
  {
    visitAll(mesh, thicknessOf(mesh, method),
      [&](const Point3& x, double value)
      {
        const bool onEnd = std::abs(x[2]) > 0.999;
        if (!onEnd || method == ThicknessMethod::Wall)
        {
          ASSERT_NEAR(value, 0.2, 0.004) << x[0] << " " << x[1] << " " << x[2];
        }
      });
  }
}

TEST(ThicknessMethods, OutsideTheyAreTheClearance)
{
  const TriangleMesh mesh = subdivided(appended(translated(box({ 1.0, 1.0, 1.0 }), { -1.1, 0, 0 }),
                                         translated(box({ 1.0, 1.0, 1.0 }), { 1.1, 0, 0 })),
    3);
  for (const ThicknessMethod method : { ThicknessMethod::Ray, ThicknessMethod::Wall })
  {
    int between = 0;
    visitAll(mesh, thicknessOf(mesh, method, Side::Exterior),
      [&](const Point3& x, double value)
      {
        if (std::abs(std::abs(x[0]) - 0.1) < 1e-9 &&
          std::max(std::abs(x[1]), std::abs(x[2])) < 0.99)
        {
          ++between;
          ASSERT_NEAR(value, 0.2, kRounding);
        }
      });
    EXPECT_GE(between, 100);
  }
}

TEST(ThicknessMethods, RaysOfASingleSheetMeetNothing)
{
  const TriangleMesh mesh = makeMesh({ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 } }, { { 0, 1, 2 } });
  const Thickness thickness = thicknessOf(mesh, ThicknessMethod::Ray, Side::Both);
  EXPECT_EQ(thickness.without, 3);
  EXPECT_TRUE(std::isnan(thickness.triangleValues[0]));
}

// Two pieces that meet without common points: a ray does not end in the other one's border.
TEST(ThicknessMethods, RaysPassTheSurfaceThatTheyStartOn)
{
  const TriangleMesh mesh = appended(
    makeMesh({ { 0, 0, 0 }, { 2, 0, 0 }, { 2, 2, 0 }, { 0, 2, 0 } }, { { 0, 1, 2 }, { 0, 2, 3 } }),
    makeMesh({ { 2, 1, 1e-9 }, { 4, 0, 1e-9 }, { 4, 2, 1e-9 }, { 0, 0, -0.5 }, { 0, 2, -0.5 },
               { 4, 1, -0.5 } },
      { { 0, 1, 2 }, { 3, 4, 5 } }));
  const Thickness thickness = thicknessOf(mesh, ThicknessMethod::Ray);
  EXPECT_NEAR(thickness.values[4], 0.5, kRounding);
}

// A ray beside such a triangle of the side that it runs along ended there.
TEST(ThicknessMethods, RaysDoNotEndAtTrianglesWithoutArea)
{
  const TriangleMesh plate = tilted(box({ 5.0, 3.0, 0.1 }));
  for (const unsigned int seed : { 1U, 2U, 3U, 4U })
  {
    const TriangleMesh mesh = withFlatTriangles(plate, 60, 0.0, seed);
    const Thickness thickness = thicknessOf(mesh, ThicknessMethod::Ray);
    EXPECT_NEAR(thickness.min, 0.2, kRounding) << seed;
    EXPECT_LT(thickness.max, 12.0) << seed;
  }
}

TEST(ThicknessMethods, AreTheSameForAnyNumberOfThreads)
{
  const TriangleMesh mesh = tilted(subdivided(wedge(40.0, 2.0, 1.0), 4));
  for (const ThicknessMethod method : { ThicknessMethod::Ray, ThicknessMethod::Wall })
  {
    ThicknessOptions options;
    options.method = method;
    options.cells = true;
    const Thickness all = computeThickness(mesh, options);
    options.execution.threads = 1;
    const Thickness one = computeThickness(mesh, options);
    EXPECT_EQ(one.values, all.values);
    EXPECT_EQ(one.triangleValues, all.triangleValues);
    EXPECT_EQ(one.triangleAtEdge, all.triangleAtEdge);
  }
}

TEST(ThicknessMethods, CellsAreEmptyUnlessAskedFor)
{
  const Thickness thickness = computeThickness(box(kBox));
  EXPECT_TRUE(thickness.triangleValues.empty());
  EXPECT_TRUE(thickness.atEdge.empty());
}
