// Do simplified axes keep the shape and the topology of the full ones?
#include "medial/simplification.h"

#include "support/axes.h"
#include "support/brute_force.h"
#include "support/medial_checks.h"
#include "support/models.h"
#include "support/point_math.h"
#include "support/shapes.h"
#include "support/simplified_axes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <set>
#include <vector>

using namespace medial;
using namespace medial::test;

namespace
{

void expectRadius(const MedialAxis& axis, double radius, double tolerance)
{
  for (const float r : axis.radius)
  {
    EXPECT_NEAR(static_cast<double>(r), radius, tolerance);
  }
}

/// No cell twice, none within another, none without area or length; no point without a cell.
void expectSoundCells(const MedialAxis& axis)
{
  std::set<std::set<std::int64_t>> cells;
  std::set<std::int64_t> used;
  const auto add = [&](const auto& cell)
  {
    const std::set<std::int64_t> corners(cell.begin(), cell.end());
    EXPECT_EQ(corners.size(), cell.size());
    EXPECT_TRUE(cells.insert(corners).second);
    used.insert(corners.begin(), corners.end());
    for (std::size_t i = 1; i < cell.size(); ++i)
    {
      EXPECT_GT(length(minus(axis.points.at(cell[0]), axis.points.at(cell[i]))), 0.0);
    }
  };
  for (const auto& t : axis.triangles)
  {
    add(t);
    MedialAxis one;
    one.points = { axis.points[t[0]], axis.points[t[1]], axis.points[t[2]] };
    one.triangles = { { 0, 1, 2 } };
    const double side = length(minus(one.points[0], one.points[1]));
    EXPECT_GT(areaOf(one), 1e-7 * side * side);
  }
  std::for_each(axis.lines.begin(), axis.lines.end(), add);
  for (const auto& t : axis.triangles)
  {
    for (const auto& [a, b] : { std::pair{ 0, 1 }, std::pair{ 1, 2 }, std::pair{ 2, 0 } })
    {
      EXPECT_EQ(cells.count({ t[a], t[b] }), 0u) << "a side is a line as well";
    }
  }
  for (const std::int64_t v : axis.vertices)
  {
    EXPECT_TRUE(used.insert(v).second);
  }
  EXPECT_TRUE(axis.quads.empty());
  EXPECT_EQ(used.size(), axis.points.size());
}

/// Points of a circle of radius R about the z axis.
MedialAxis ring(double R, double radius, int count)
{
  AxisBuilder builder;
  for (int i = 0; i < count; ++i)
  {
    const double angle = 2.0 * kPi * i / count;
    builder.add({ R * std::cos(angle), R * std::sin(angle), 0.0 }, radius);
    builder.axis.lines.push_back({ i, (i + 1) % count });
  }
  return builder.axis;
}

} // namespace

TEST(AxisSimplification, KeepsThePlaneOutlineAndRadiusOfASheet)
{
  const MedialAxis full = plate();
  for (const std::int64_t count : { 4, 7, 40 })
  {
    const MedialAxis axis = simplified(full, count);
    EXPECT_EQ(axis.points.size(), static_cast<std::size_t>(count));
    EXPECT_NEAR(areaOf(axis), 6.0, 1e-5);
    EXPECT_EQ(eulerCharacteristic(axis), 1);
    expectRadius(axis, 0.4, 1e-5);
    expectSoundCells(axis);
    for (const Point3& corner : { Point3{ 1.0, 2.0, 3.0 }, Point3{ 4.0, 2.0, 3.0 },
           Point3{ 1.0, 3.6, 4.2 }, Point3{ 4.0, 3.6, 4.2 } })
    {
      EXPECT_LT(nearest(axis, corner), 1e-4);
    }
    for (const Point3& p : axis.points)
    {
      EXPECT_NEAR(0.6 * (p[1] - 2.0), 0.8 * (p[2] - 3.0), 1e-6);
    }
  }
}

TEST(AxisSimplification, OfACapsuleIsItsTwoEnds)
{
  AxisBuilder builder;
  builder.addCurve({ -1.0, 0.5, 0.2 }, { 1.0, 0.5, 0.2 }, 100, 0.3);
  const MedialAxis axis = simplified(builder.axis, 2);
  ASSERT_EQ(axis.points.size(), 2u);
  EXPECT_LT(nearest(axis, { -1.0, 0.5, 0.2 }), 1e-4);
  EXPECT_LT(nearest(axis, { 1.0, 0.5, 0.2 }), 1e-4);
  EXPECT_EQ(axis.lines.size(), 1u);
  expectRadius(axis, 0.3, 1e-5);
}

TEST(AxisSimplification, OfAComputedCapsuleIsItsTwoEnds)
{
  const double h = 0.04;
  const MedialAxis axis = axisOf(uvCapsule(0.4, 0.8, 64), h, 2);
  ASSERT_EQ(axis.points.size(), 2u);
  EXPECT_LT(nearest(axis, { 0.0, 0.0, -0.8 }), thickening(h, 60.0));
  EXPECT_LT(nearest(axis, { 0.0, 0.0, 0.8 }), thickening(h, 60.0));
  expectRadius(axis, 0.4, 0.2 * h);
}

TEST(AxisSimplification, OfACurveOfChangingRadiusIsACone)
{
  AxisBuilder builder;
  for (int i = 0; i <= 50; ++i)
  {
    builder.add({ 0.04 * i, 0.0, 0.0 }, 0.5 - 0.006 * i);
    if (i > 0)
    {
      builder.axis.lines.push_back({ i - 1, i });
    }
  }
  const MedialAxis axis = simplified(builder.axis, 2);
  ASSERT_EQ(axis.points.size(), 2u);
  for (std::size_t i = 0; i < 2; ++i)
  {
    EXPECT_NEAR(static_cast<double>(axis.radius[i]), 0.5 - 0.15 * axis.points[i][0], 1e-4);
  }
  EXPECT_NEAR(length(minus(axis.points[0], axis.points[1])), 2.0, 1e-3);
}

TEST(AxisSimplification, KeepsTheLoopOfARing)
{
  const MedialAxis full = ring(1.0, 0.3, 120);
  for (const std::int64_t count : { 3, 4, 12 })
  {
    const MedialAxis axis = simplified(full, count);
    EXPECT_EQ(axis.points.size(), static_cast<std::size_t>(count));
    EXPECT_EQ(eulerCharacteristic(axis), 0);
    EXPECT_EQ(componentCount(axis), 1);
    EXPECT_EQ(axis.simplification.forced, 0);
    expectSoundCells(axis);
  }
  const MedialAxis axis = simplified(full, 2); // closes it, and says so
  EXPECT_EQ(axis.points.size(), 2u);
  EXPECT_EQ(axis.simplification.forced, 1);
}

TEST(AxisSimplification, KeepsTheLoopOfAComputedTorus)
{
  const TriangleMesh mesh = torus(1.0, 0.3, 64, 32);
  for (const std::int64_t count : { 3, 10, 40 })
  {
    const MedialAxis axis = axisOf(mesh, 0.05, count);
    EXPECT_EQ(axis.points.size(), static_cast<std::size_t>(count));
    EXPECT_EQ(eulerCharacteristic(axis), 0);
    EXPECT_EQ(componentCount(axis), 1);
    expectSoundCells(axis);
  }
}

TEST(AxisSimplification, KeepsTheHollowOfASphere)
{
  const MedialAxis full = sphereSheet(1.0, 0.1);
  for (const std::int64_t count : { 4, 20, 100 })
  {
    const MedialAxis axis = simplified(full, count);
    EXPECT_EQ(axis.points.size(), static_cast<std::size_t>(count));
    EXPECT_EQ(eulerCharacteristic(axis), 2);
    expectSoundCells(axis);
  }
}

TEST(AxisSimplification, KeepsTheHollowOfAComputedShell)
{
  const MedialAxis axis = axisOf(shell(0.8, 1.0, 3), 0.06, 60);
  EXPECT_EQ(axis.points.size(), 60u);
  EXPECT_EQ(eulerCharacteristic(axis), 2);
  expectRadius(axis, 0.1, 0.05);
}

TEST(AxisSimplification, OfABallIsOneBall)
{
  const MedialAxis axis = axisOf(icosphere(1.0, 4), 0.07, 1);
  ASSERT_EQ(axis.points.size(), 1u);
  EXPECT_EQ(axis.vertices.size(), 1u);
  EXPECT_LT(nearest(axis, { 0.0, 0.0, 0.0 }), 0.02);
  expectRadius(axis, 1.0, 0.01);
}

TEST(AxisSimplification, KeepsTheSeamOfThreeSheets)
{
  AxisBuilder builder;
  for (int i = 0; i < 3; ++i)
  {
    const double angle = 0.2 + 2.0 * kPi * i / 3;
    builder.addSheet({ 0.0, 0.0, -1.0 }, { std::cos(angle), std::sin(angle), 0.0 },
      { 0.0, 0.0, 2.0 }, 16, 0.15);
  }
  const MedialAxis axis = simplified(builder.axis, 8); // two ends of the seam and six corners
  EXPECT_EQ(axis.points.size(), 8u);
  EXPECT_NEAR(areaOf(axis), 6.0, 6e-3);
  EXPECT_EQ(eulerCharacteristic(axis), 1);
  EXPECT_LT(nearest(axis, { 0.0, 0.0, -1.0 }), 2e-3);
  EXPECT_LT(nearest(axis, { 0.0, 0.0, 1.0 }), 2e-3);
  EXPECT_EQ(std::count(axis.feature.begin(), axis.feature.end(), AxisFeature::Junction), 2);
  EXPECT_EQ(std::count(axis.feature.begin(), axis.feature.end(), AxisFeature::Rim), 6);
  expectRadius(axis, 0.15, 5e-4);
  expectSoundCells(axis);
}

TEST(AxisSimplification, ClosesAHoleThatTheBallsFill)
{
  MedialAxis full = plate();
  const auto hole = full.quads.begin() + 24 * 12 + 12;
  full.quads.erase(hole);
  ASSERT_EQ(eulerCharacteristic(full), 0);
  const MedialAxis axis = simplified(full, 4);
  EXPECT_EQ(eulerCharacteristic(axis), 1);
  EXPECT_NEAR(areaOf(axis), 6.0, 1e-3);
  EXPECT_EQ(axis.simplification.forced, 0);
}

TEST(AxisSimplification, KeepsSuchAHoleOfAnAxisWithPreservedTopology)
{
  MedialAxis full = plate();
  full.quads.erase(full.quads.begin() + 24 * 12 + 12);
  full.solid = topologyOf(full);
  ASSERT_EQ(full.solid->eulerCharacteristic, 0);
  EXPECT_EQ(topologyOf(simplified(full, 12)), *full.solid);
  // Two balls have no loop.
  EXPECT_EQ(eulerCharacteristic(simplified(full, 2)), 1);
}

TEST(AxisSimplification, JoinsOnlyComponentsWhoseBallsOverlap)
{
  AxisBuilder builder;
  builder.addCurve({ 0.0, 0.0, 0.0 }, { 1.0, 0.0, 0.0 }, 20, 0.3);
  builder.addCurve({ 1.5, 0.0, 0.0 }, { 2.5, 0.0, 0.0 }, 20, 0.3); // 0.5 < 0.6: one solid
  builder.addCurve({ 0.0, 0.6, 0.0 }, { 2.5, 0.6, 0.0 }, 20, 0.3); // touches them
  const MedialAxis axis = simplified(builder.axis, 5);
  EXPECT_EQ(axis.simplification.inputComponents, 3);
  EXPECT_EQ(axis.simplification.joined, 1);
  EXPECT_EQ(axis.simplification.components, 2);
  EXPECT_EQ(componentCount(axis), 2);
}

TEST(AxisSimplification, DropsTheSmallestComponentsLast)
{
  AxisBuilder builder;
  for (int i = 0; i < 5; ++i)
  {
    builder.addCurve({ 0.0, 2.0 * i, 0.0 }, { 1.0, 2.0 * i, 0.0 }, 10, 0.1 * (i + 1));
  }
  EXPECT_EQ(simplified(builder.axis, 5).simplification.components, 5);
  const MedialAxis axis = simplified(builder.axis, 2);
  EXPECT_EQ(axis.simplification.dropped, 3);
  EXPECT_EQ(axis.vertices.size(), 2u);
  ASSERT_EQ(axis.radius.size(), 2u);
  EXPECT_GT(*std::min_element(axis.radius.begin(), axis.radius.end()), 0.39F);
}

TEST(AxisSimplification, OfABoxIsItsSheets)
{
  const MedialAxis axis = axisOf(box({ 1.0, 0.7, 0.4 }), 0.03, 24, 60.0);
  EXPECT_EQ(componentCount(axis), 1);
  const double whole = 4.0 * 0.6 * 0.3 + 4.0 * std::sqrt(2.0) * (2.0 * 0.4 * 1.7 - 0.16);
  EXPECT_NEAR(areaOf(axis), whole, 0.06 * whole);
  for (std::size_t i = 0; i < axis.points.size(); ++i)
  {
    const Point3& p = axis.points[i];
    const double exact =
      std::min({ 1.0 - std::abs(p[0]), 0.7 - std::abs(p[1]), 0.4 - std::abs(p[2]) });
    EXPECT_NEAR(static_cast<double>(axis.radius[i]), exact, 0.03);
  }
}

TEST(AxisSimplification, MoreBallsDescribeTheSurfaceBetter)
{
  std::vector<TriangleMesh> meshes{ ellipsoid(1.0, 0.6, 0.4, 4), lPrism(1.0, 0.5) };
  if (const auto path = modelPath("paper/triceratops.off"))
  {
    meshes.push_back(buildTriangleMesh(loadModel(*path)));
  }
  for (const TriangleMesh& mesh : meshes)
  {
    const Bounds bounds = mesh.bounds();
    const double diagonal = length(minus(bounds.min, bounds.max));
    MedialAxisOptions options;
    options.angle = 30.0;
    const MedialAxis full = computeMedialAxis(mesh, makeGrid(mesh.bounds(), 64, 0.1), options);
    const std::vector<Point3> surface = randomPointsOn(mesh, 500);
    double last = std::numeric_limits<double>::infinity();
    for (const std::int64_t count : { 10, 40, 160 })
    {
      const std::vector<double> errors = distancesToModel(simplified(full, count), surface);
      const double mean = std::accumulate(errors.begin(), errors.end(), 0.0,
                            [](double sum, double e) { return sum + std::abs(e); }) /
        static_cast<double>(errors.size());
      EXPECT_LT(mean, last) << count;
      last = mean;
    }
    EXPECT_LT(last, 0.004 * diagonal);
  }
}
