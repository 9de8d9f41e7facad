// Thickness of surfaces whose faces do not share their points, as CAD programs write them, and of
// bodies that touch.
#include "medial/subdivision.h"
#include "medial/thickness_regions.h"

#include "support/shapes.h"
#include "support/transforms.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <random>
#include <vector>

using namespace medial;
using namespace medial::test;

namespace
{

constexpr double kThin = 0.5;

Thickness thicknessOf(const TriangleMesh& mesh, ThicknessMethod method)
{
  ThicknessOptions options;
  options.method = method;
  options.side = Side::Interior;
  options.cells = true;
  return computeThickness(mesh, options);
}

std::size_t thinRegions(const TriangleMesh& mesh, ThicknessMethod method)
{
  return findThicknessRegions(mesh, thicknessOf(mesh, method), { kThin, std::nullopt }).size();
}

/// The least value of all that are numbers.
float least(const TriangleMesh& mesh, ThicknessMethod method)
{
  float min = std::numeric_limits<float>::infinity();
  for (const float value : thicknessOf(mesh, method).values)
  {
    min = std::isnan(value) ? min : std::min(min, value);
  }
  return min;
}

/// A cylinder of radius 1 and height 2 whose caps have corners of their own, of another number or
/// moved.
TriangleMesh cylinderWithLooseCaps(int sides, int corners, double noise)
{
  const double turn = 2.0 * std::acos(-1.0);
  std::mt19937 random(1);
  std::normal_distribution<double> moved(0.0, noise);
  TriangleMesh mesh;
  const auto add = [&](double angle, double z, double deviation)
  {
    Point3 point{ std::cos(angle), std::sin(angle), z };
    for (double& coordinate : point)
    {
      coordinate += deviation > 0.0 ? moved(random) : 0.0;
    }
    mesh.points.push_back(point);
  };
  for (int i = 0; i < sides; ++i)
  {
    add(turn * i / sides, 0.0, 0.0);
    add(turn * i / sides, 2.0, 0.0);
    const int a = 2 * i;
    const int b = 2 * ((i + 1) % sides);
    mesh.triangles.push_back({ a, b, b + 1 });
    mesh.triangles.push_back({ a, b + 1, a + 1 });
  }
  for (const double z : { 0.0, 2.0 })
  {
    const auto middle = static_cast<int>(mesh.points.size());
    mesh.points.push_back({ 0.0, 0.0, z });
    for (int i = 0; i < corners; ++i)
    {
      add(turn * i / corners, z, noise);
      const int a = middle + 1 + i;
      const int b = middle + 1 + (i + 1) % corners;
      mesh.triangles.push_back(
        z > 1.0 ? std::array<int, 3>{ middle, a, b } : std::array<int, 3>{ middle, b, a });
    }
  }
  return subdivide(makeMesh(mesh.points, mesh.triangles), 0.2).mesh;
}

/// A turned box of 4 x 2 x 1 whose top consists of two halves, which end in the middle of edges of
/// the sides, with coordinates of single precision.
TriangleMesh boxWithHalvedTop()
{
  const TriangleMesh box = makeMesh(
    { { -2, -1, -0.5 }, { -2, -1, 0.5 }, { -2, 1, -0.5 }, { -2, 1, 0.5 }, { 2, -1, -0.5 },
      { 2, -1, 0.5 }, { 2, 1, -0.5 }, { 2, 1, 0.5 }, { 0.3, 1, 0.5 }, { 0.3, -1, 0.5 } },
    { { 0, 1, 3 }, { 0, 3, 2 }, { 4, 6, 7 }, { 4, 7, 5 }, { 0, 4, 5 }, { 0, 5, 1 }, { 2, 3, 7 },
      { 2, 7, 6 }, { 0, 2, 6 }, { 0, 6, 4 }, { 1, 9, 8 }, { 1, 8, 3 }, { 9, 5, 7 }, { 9, 7, 8 } });
  TriangleMesh mesh = turned(turned(box, 2, 0.7), 0, 0.4);
  for (Point3& point : mesh.points)
  {
    for (double& coordinate : point)
    {
      coordinate = static_cast<double>(static_cast<float>(coordinate));
    }
  }
  return subdivide(mesh, 0.1).mesh;
}

/// A box of 2 x 2 x 2, on the middle of whose upper side one of 1 x 1 x 1 stands.
TriangleMesh bodiesThatTouch()
{
  return appended(subdivided(box({ 1.0, 1.0, 1.0 }), 3),
    translated(subdivided(box({ 0.5, 0.5, 0.5 }), 3), { 0.03, 0.02, 1.5 }));
}

} // namespace

TEST(ThicknessSeams, AreNoThinWalls)
{
  for (const TriangleMesh& mesh : { cylinderWithLooseCaps(48, 48, 1e-7),
         cylinderWithLooseCaps(48, 36, 0.0), cylinderWithLooseCaps(96, 64, 0.0) })
  {
    EXPECT_EQ(thinRegions(mesh, ThicknessMethod::Wall), 0u);
    EXPECT_GT(least(mesh, ThicknessMethod::Wall), 1.95f);
  }
  EXPECT_EQ(thinRegions(boxWithHalvedTop(), ThicknessMethod::Wall), 0u);
  EXPECT_NEAR(least(boxWithHalvedTop(), ThicknessMethod::Wall), 1.0f, 1e-3f);
}

// They pass the next face, which they run along.
TEST(ThicknessSeams, DoNotEndRays)
{
  for (const TriangleMesh& mesh :
    { cylinderWithLooseCaps(48, 48, 1e-7), cylinderWithLooseCaps(48, 36, 0.0) })
  {
    EXPECT_GT(least(mesh, ThicknessMethod::Ray), 1.9f);
  }
}

TEST(ThicknessSeams, RaysPassTheBodyThatTheirsStandsOn)
{
  EXPECT_EQ(thinRegions(bodiesThatTouch(), ThicknessMethod::Ray), 0u);
  // At the upper edge of the lower body rays end at the side of the other one.
  EXPECT_NEAR(least(bodiesThatTouch(), ThicknessMethod::Ray), 0.47f, 1e-5f);
}

// A thin wall stays one where its sides are not welded.
TEST(ThicknessSeams, ThinWallsWithLooseSidesAreFound)
{
  TriangleMesh plate = subdivided(box({ 2.0, 1.0, 0.05 }), 3);
  TriangleMesh loose;
  for (const auto& triangle : plate.triangles)
  {
    const auto first = static_cast<int>(loose.points.size());
    for (const int corner : triangle)
    {
      Point3 point = plate.points[corner];
      point[0] += 1e-7 * (first % 7);
      loose.points.push_back(point);
    }
    loose.triangles.push_back({ first, first + 1, first + 2 });
  }
  loose = makeMesh(loose.points, loose.triangles);
  EXPECT_GE(thinRegions(loose, ThicknessMethod::Wall), 1u);
  EXPECT_NEAR(least(loose, ThicknessMethod::Wall), 0.1f, 1e-3f);
}
