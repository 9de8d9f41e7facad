// Thickness of shapes for which it is known in closed form.
#include "medial/thickness.h"

#include "support/medial_truth.h"
#include "support/point_math.h"
#include "support/shapes.h"
#include "support/thickness_oracle.h"
#include "support/transforms.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

using namespace medial;
using namespace medial::test;

namespace
{

/// The tolerance of single precision, relative to values about 1.
constexpr double kRounding = 3e-7;

Thickness thicknessOf(const TriangleMesh& mesh, Side side = Side::Interior, double angle = 60.0)
{
  ThicknessOptions options;
  options.side = side;
  options.angle = angle;
  return computeThickness(mesh, options);
}

void expectEverywhere(const Thickness& thickness, double value, double tolerance)
{
  EXPECT_EQ(thickness.without, 0);
  EXPECT_NEAR(thickness.min, value, tolerance);
  EXPECT_NEAR(thickness.max, value, tolerance);
}

/// Largest difference from a truth that is given for every point.
double worst(const TriangleMesh& mesh, const Thickness& thickness,
  const std::function<double(const Point3&)>& truth)
{
  double largest = 0.0;
  for (std::size_t i = 0; i < mesh.points.size(); ++i)
  {
    const double error = std::abs(static_cast<double>(thickness.values[i]) - truth(mesh.points[i]));
    largest = std::isnan(error) ? HUGE_VAL : std::max(largest, error);
  }
  return largest;
}

double worst(const TriangleMesh& mesh, double truth)
{
  return worst(mesh, thicknessOf(mesh), [truth](const Point3&) { return truth; });
}

/// Twice the distance to the nearest other side; 0 on edges.
double boxThickness(const Point3& halfSides, const Point3& x)
{
  Point3 gaps{};
  double widest = 2.0 * *std::min_element(halfSides.begin(), halfSides.end());
  for (int axis = 0; axis < 3; ++axis)
  {
    gaps[axis] = halfSides[axis] - std::abs(x[axis]);
  }
  const auto own = std::min_element(gaps.begin(), gaps.end());
  widest = 2.0 * halfSides[own - gaps.begin()];
  *own = HUGE_VAL;
  return std::min(widest, 2.0 * *std::min_element(gaps.begin(), gaps.end()));
}

/// Between the sphere of radius `inner` about the origin and the one of radius `outer` about
/// (e, 0, 0): the ball on the normal of the one that x lies on that touches the other.
double eccentricThickness(double inner, double outer, double e, const Point3& x)
{
  const double size = std::sqrt(dot(x, x));
  const Point3 w{ x[0] - e, x[1], x[2] };
  if (size < 1.001 * inner)
  {
    const double along = dot(w, x) / size;
    return (outer * outer - dot(w, w)) / (along + outer);
  }
  const double along = dot(x, w) / outer;
  return (size * size - inner * inner) / (along + inner);
}

TriangleMesh eccentricShell(double inner, double outer, double e, int subdivisions)
{
  return appended(translated(icosphere(outer, subdivisions), { e, 0.0, 0.0 }),
    flipOrientation(icosphere(inner, subdivisions)));
}

/// A cone with its tip up and a flat base; `angle` is between the axis and the side, degrees.
TriangleMesh cone(double angle, int segments)
{
  std::vector<Point3> points{ { 0.0, 0.0, 1.0 }, { 0.0, 0.0, 0.0 } };
  std::vector<std::array<int, 3>> triangles;
  const double radius = std::tan(angle * kPi / 180.0);
  for (int i = 0; i < segments; ++i)
  {
    const double turn = 2.0 * kPi * i / segments;
    points.push_back({ radius * std::cos(turn), radius * std::sin(turn), 0.0 });
    const int next = 2 + (i + 1) % segments;
    triangles.push_back({ 0, 2 + i, next });
    triangles.push_back({ 1, next, 2 + i });
  }
  return makeMesh(points, triangles);
}

} // namespace

TEST(Thickness, BetweenPlatesIsTheirGap)
{
  const TriangleMesh mesh = subdivided(plates(0.37, 1.0), 3);
  expectEverywhere(thicknessOf(mesh), 0.37, kRounding);
  expectEverywhere(thicknessOf(tilted(mesh)), 0.37, kRounding);
  expectEverywhere(thicknessOf(mesh, Side::Both), 0.37, kRounding);
}

// However thin beside the triangles.
TEST(Thickness, OfAThinGapIsExact)
{
  for (const double gap : { 1e-2, 1e-4, 1e-6 })
  {
    expectEverywhere(thicknessOf(plates(gap, 1.0)), gap, 1e-6 * gap + 1e-12);
  }
}

TEST(Thickness, OutsideOfPlatesThereIsNone)
{
  const Thickness thickness = thicknessOf(plates(0.37, 1.0), Side::Exterior);
  EXPECT_EQ(thickness.without, 8);
  EXPECT_EQ(thickness.shareWithout(), 1.0);
  EXPECT_TRUE(std::isnan(thickness.median));
}

TEST(Thickness, OfABoxIsTwiceTheDistanceToTheNearestSide)
{
  const Point3 halfSides{ 1.0, 0.7, 0.4 };
  const TriangleMesh mesh = subdivided(box(halfSides), 4);
  const auto truth = [&](const Point3& x) { return boxThickness(halfSides, x); };
  EXPECT_LE(worst(mesh, thicknessOf(mesh), truth), kRounding);
  EXPECT_LE(worst(mesh, thicknessOf(tilted(mesh)), truth), kRounding);
}

TEST(Thickness, OfPartsThatFaceDifferentWays)
{
  const Point3 halfSides{ 1.0, 0.7, 0.4 };
  const TriangleMesh part = subdivided(box(halfSides), 3);
  const TriangleMesh mesh = appended(part, flipOrientation(translated(part, { 4.0, 0.0, 0.0 })));
  const auto truth = [&](const Point3& x) {
    return boxThickness(halfSides, { x[0] > 2.0 ? x[0] - 4.0 : x[0], x[1], x[2] });
  };
  EXPECT_LE(worst(mesh, thicknessOf(mesh), truth), kRounding);
}

// Above 90 degrees the sheets that run into the edges do not count, only the one in the middle.
TEST(Thickness, ForWideAnglesIsThatOfTheMiddleSheet)
{
  const Point3 halfSides{ 1.0, 0.7, 0.05 };
  const TriangleMesh mesh = subdivided(box(halfSides), 4);
  const Thickness thickness = thicknessOf(mesh, Side::Interior, 100.0);
  for (std::size_t i = 0; i < mesh.points.size(); ++i)
  {
    const Point3& x = mesh.points[i];
    if (std::abs(x[0]) < 0.99 && std::abs(x[1]) < 0.69)
    {
      ASSERT_NEAR(thickness.values[i], 0.1, kRounding);
    }
  }
}

// Within half the height of an edge balls touch two sides at 90 degrees and nothing opposite.
TEST(Thickness, OfWhatThetaExcludesThereIsNone)
{
  const Point3 halfSides{ 2.0, 1.0, 0.5 };
  const TriangleMesh mesh = subdivided(box(halfSides), 5);
  for (const double angle : { 30.0, 60.0, 85.0, 95.0, 120.0, 150.0, 175.0 })
  {
    for (const TriangleMesh& turned : { mesh, tilted(mesh) })
    {
      const Thickness thickness = thicknessOf(turned, Side::Interior, angle);
      int strip = 0;
      int middle = 0;
      for (std::size_t i = 0; i < mesh.points.size(); ++i)
      {
        const Point3& x = mesh.points[i];
        const double truth = boxThickness(halfSides, x);
        const bool onFace = std::abs(x[2]) > 0.499 && truth > 0.0;
        const bool excluded = angle > 90.0 && truth < 0.95;
        strip += onFace && truth < 0.95 ? 1 : 0;
        middle += onFace && truth > 0.999 ? 1 : 0;
        if (onFace && excluded)
        {
          ASSERT_TRUE(std::isnan(thickness.values[i])) << angle << " at gap " << 0.5 * truth;
        }
        else if (onFace && (angle < 90.0 || truth > 0.999))
        {
          ASSERT_NEAR(thickness.values[i], truth, kRounding) << angle;
        }
      }
      EXPECT_GE(strip, 100);
      EXPECT_GE(middle, 100);
    }
  }
}

// An edge that bends by less than theta is passed over: the opposite side counts.
TEST(Thickness, OnEdgesThatBendByLessIsThatOpposite)
{
  const TriangleMesh mesh = subdivided(box({ 2.0, 1.0, 0.5 }), 2);
  const Thickness thickness = thicknessOf(mesh, Side::Interior, 120.0);
  for (std::size_t i = 0; i < mesh.points.size(); ++i)
  {
    const Point3& x = mesh.points[i];
    if (std::abs(x[2]) > 0.499 && std::abs(x[1]) > 0.999)
    {
      ASSERT_NEAR(thickness.values[i], 1.0, kRounding);
    }
  }
}

// The excluded strip of a curved surface is as wide as that of a flat one, however it is divided.
TEST(Thickness, OfCurvedSurfacesIsKeptAtWideAngles)
{
  for (const double angle : { 60.0, 120.0, 150.0 })
  {
    const TriangleMesh ball = icosphere(1.0, 3);
    const Thickness thickness = thicknessOf(ball, Side::Interior, angle);
    EXPECT_EQ(thickness.without, 0) << angle;
    EXPECT_NEAR(thickness.min, 2.0, 0.03) << angle;
  }
}

TEST(Thickness, OfAShellIsTheDifferenceOfTheRadii)
{
  const double coarse = worst(shell(0.6, 1.0, 3), 0.4);
  const double fine = worst(shell(0.6, 1.0, 4), 0.4);
  EXPECT_LE(coarse, 0.005);
  EXPECT_LE(fine, 0.3 * coarse);
}

TEST(Thickness, OfABallIsItsDiameter)
{
  const double coarse = worst(icosphere(1.0, 3), 2.0);
  const double fine = worst(icosphere(1.0, 4), 2.0);
  EXPECT_LE(coarse, 0.025);
  EXPECT_LE(fine, 0.45 * coarse);
}

TEST(Thickness, OfACapsuleIsItsDiameter)
{
  const double coarse = worst(uvCapsule(0.5, 0.8, 32), 1.0);
  const double fine = worst(uvCapsule(0.5, 0.8, 64), 1.0);
  EXPECT_LE(coarse, 0.02);
  EXPECT_LE(fine, 0.35 * coarse);
}

TEST(Thickness, OfATorusIsThatOfItsTube)
{
  const double coarse = worst(torus(1.0, 0.3, 64, 32), 0.6);
  const double fine = worst(torus(1.0, 0.3, 128, 64), 0.6);
  EXPECT_LE(coarse, 0.006);
  EXPECT_LE(fine, 0.35 * coarse);
}

TEST(Thickness, OfACylinder)
{
  // Twice the minimum of radius, half height and distance to the rim; 0 on the rim.
  const auto truth = [](const Point3& x)
  {
    const double rho = std::hypot(x[0], x[1]);
    const bool onCap = std::abs(x[2]) > 1.0 - 1e-9;
    return onCap ? 2.0 * std::min(0.5 - rho, 1.0) : 2.0 * std::min(0.5, 1.0 - std::abs(x[2]));
  };
  const auto error = [&](int sides)
  {
    const TriangleMesh mesh = cylinder(0.5, 2.0, sides);
    // The rim is on the circle; other points of these are the middles of the caps only.
    return worst(mesh, thicknessOf(mesh), [&](const Point3& x) { return std::max(truth(x), 0.0); });
  };
  EXPECT_LE(error(64), 0.003);
  EXPECT_LE(error(128), 0.3 * error(64));
}

TEST(Thickness, OfAnEccentricShell)
{
  const auto error = [](int subdivisions)
  {
    const TriangleMesh mesh = eccentricShell(0.5, 1.0, 0.2, subdivisions);
    return worst(mesh, thicknessOf(mesh),
      [](const Point3& x) { return eccentricThickness(0.5, 1.0, 0.2, x); });
  };
  EXPECT_LE(error(4), 0.004);
  EXPECT_LE(error(4), 0.3 * error(3));
}

TEST(Thickness, OnSharpConvexEdgesAndTipsIsNothing)
{
  EXPECT_EQ(thicknessOf(box({ 1.0, 0.7, 0.4 })).max, 0.0);
  EXPECT_EQ(thicknessOf(regularTetrahedron(1.0)).max, 0.0);
  const TriangleMesh steep = cone(30.0, 64);
  EXPECT_EQ(thicknessOf(steep).values[0], 0.0f);
}

// A tip of 2 x 75 degrees is blunt: the normals around it are 30 degrees apart. Its ball touches
// the base.
TEST(Thickness, OnBluntTipsIsThatBehindThem)
{
  const double angle = 75.0 * kPi / 180.0;
  // The ball inside the cone's tip that touches the base, of height 1.
  const double expected = 2.0 * std::sin(angle) / (1.0 + std::sin(angle));
  EXPECT_NEAR(thicknessOf(cone(75.0, 256)).values[0], expected, 1e-3);
}

// Seen from outside a reflex edge is the convex one.
TEST(Thickness, AtReflexEdgesIsThatOppositeAndOutsideNothing)
{
  const TriangleMesh mesh = subdivided(lPrism(1.0, 3.0), 4);
  const Thickness inside = thicknessOf(mesh);
  const Thickness outside = thicknessOf(mesh, Side::Exterior);
  int onEdge = 0;
  for (std::size_t i = 0; i < mesh.points.size(); ++i)
  {
    const Point3& x = mesh.points[i];
    if (x[0] == 0.0 && x[1] == 0.0 && std::abs(x[2]) < 1.5)
    {
      ++onEdge;
      // The ball through the edge that touches both sides opposite, at -1: r = (1 - r / sqrt 2).
      ASSERT_NEAR(inside.values[i], 2.0 / (1.0 + std::sqrt(0.5)), kRounding);
      ASSERT_EQ(outside.values[i], 0.0f);
    }
  }
  EXPECT_GE(onEdge, 5);
}

TEST(Thickness, OfTheExteriorIsTheClearance)
{
  const TriangleMesh mesh =
    subdivided(appended(translated(box({ 1.0, 1.0, 1.0 }), { -1.1, 0.0, 0.0 }),
                 translated(box({ 1.0, 1.0, 1.0 }), { 1.1, 0.0, 0.0 })),
      3);
  const Thickness thickness = thicknessOf(mesh, Side::Exterior);
  int between = 0;
  for (std::size_t i = 0; i < mesh.points.size(); ++i)
  {
    const Point3& x = mesh.points[i];
    const bool facing = std::abs(std::abs(x[0]) - 0.1) < 1e-9;
    const bool inside = std::max(std::abs(x[1]), std::abs(x[2])) < 0.99;
    if (facing && inside)
    {
      ++between;
      ASSERT_NEAR(thickness.values[i], 0.2, kRounding);
    }
    else if (inside && std::abs(x[0]) > 2.0)
    {
      ASSERT_TRUE(std::isnan(thickness.values[i]));
    }
  }
  EXPECT_GE(between, 50);
}

TEST(Thickness, OfBothSidesIsTheSmaller)
{
  const TriangleMesh mesh = torus(1.0, 0.3, 48, 24);
  const Thickness inside = thicknessOf(mesh);
  const Thickness outside = thicknessOf(mesh, Side::Exterior);
  const Thickness both = thicknessOf(mesh, Side::Both);
  for (std::size_t i = 0; i < mesh.points.size(); ++i)
  {
    ASSERT_EQ(both.values[i], std::fmin(inside.values[i], outside.values[i]));
  }
  EXPECT_GT(outside.without, 0);
  EXPECT_EQ(both.without, 0);
}

// The ball under the middle of the plate touches the tube, whose triangles have no area.
TEST(Thickness, AHairIsSeen)
{
  constexpr double kGap = 0.4;
  const TriangleMesh plate =
    makeMesh({ { 0, -0.5, kGap }, { 0, 0, kGap }, { 0.1, 0.5, kGap }, { -0.1, 0.5, kGap } },
      { { 0, 1, 2 }, { 0, 3, 1 }, { 1, 3, 2 } });
  const TriangleMesh mesh = appended(plate, hair(0.6, 6));
  const Thickness thickness = thicknessOf(mesh, Side::Both);
  EXPECT_EQ(mesh.points[1][1], 0.0);
  EXPECT_NEAR(thickness.values[1], kGap, kRounding);
}
