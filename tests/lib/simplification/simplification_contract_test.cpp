// What callers of simplifyAxis() may expect, and what it refuses.
#include "medial/simplification.h"

#include "medial/error.h"
#include "support/axes.h"
#include "support/errors.h"
#include "support/point_math.h"
#include "support/recorded_progress.h"
#include "support/shapes.h"
#include "support/simplified_axes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <set>
#include <string>

using namespace medial;
using namespace medial::test;

namespace
{

void scale(MedialAxis& axis, double factor)
{
  for (Point3& p : axis.points)
  {
    p = { factor * p[0], factor * p[1], factor * p[2] };
  }
  const auto f = static_cast<float>(factor);
  for (float& r : axis.radius)
  {
    r *= f;
  }
  for (auto* points : { &axis.closestPointA, &axis.closestPointB })
  {
    for (auto& p : *points)
    {
      p = { f * p[0], f * p[1], f * p[2] };
    }
  }
}

} // namespace

TEST(AxisSimplification, ReturnsSmallAxesAsTheyAre)
{
  const MedialAxis full = plate();
  const MedialAxis axis = simplified(full, 625);
  EXPECT_EQ(axis.points, full.points);
  EXPECT_EQ(axis.quads, full.quads);
  EXPECT_EQ(simplified(MedialAxis(), 1).points.size(), 0u);
}

TEST(AxisSimplification, DoesNotDependOnThreadsOrSize)
{
  const MedialAxis full = axisOf(lPrism(1.0, 0.6), 0.05, 0, 30.0);
  const MedialAxis expected = simplified(full, 60);
  SimplificationOptions options;
  options.maxSpheres = 60;
  options.execution.threads = 1;
  EXPECT_EQ(simplifyAxis(full, options).points, expected.points);

  MedialAxis larger = full;
  scale(larger, 1048576.0); // a power of two: nothing is rounded
  MedialAxis result = simplified(larger, 60);
  scale(result, 1.0 / 1048576.0);
  EXPECT_EQ(result.points, expected.points);
  EXPECT_EQ(result.radius, expected.radius);
  EXPECT_EQ(result.triangles, expected.triangles);
  EXPECT_EQ(result.lines, expected.lines);
}

TEST(AxisSimplification, WorksFarFromTheOrigin)
{
  MedialAxis far = plate();
  for (Point3& p : far.points)
  {
    p = { p[0] + 1e6, p[1] - 2e6, p[2] };
  }
  const MedialAxis axis = simplified(far, 4);
  EXPECT_NEAR(areaOf(axis), 6.0, 1e-5);
  EXPECT_LT(nearest(axis, { 1000004.0, -1999998.0, 3.0 }), 1e-4);
}

TEST(AxisSimplification, AttributesAreThoseOfTheInput)
{
  const MedialAxis full = axisOf(box({ 1.0, 0.7, 0.4 }), 0.05);
  const MedialAxis axis = simplified(full, 50);
  ASSERT_EQ(axis.points.size(), 50u);
  ASSERT_EQ(axis.closestPointB.size(), 50u);
  const std::set<float> known(full.separationAngle.begin(), full.separationAngle.end());
  for (std::size_t i = 0; i < 50; ++i)
  {
    EXPECT_EQ(known.count(axis.separationAngle[i]), 1u);
    const double half = static_cast<double>(axis.separationAngle[i]) * kPi / 360.0;
    EXPECT_NEAR(static_cast<double>(axis.lambda[i]),
      static_cast<double>(axis.radius[i]) * std::sin(half), 1e-6);
  }
}

TEST(AxisSimplification, RefusesWhatItCannotUse)
{
  const MedialAxis full = plate();
  expectError([&] { simplified(full, 0); }, ErrorCode::InvalidInput,
    "spheres 0 is outside [1, infinity)");
  MedialAxis bad = full;
  bad.radius[7] = -1.0F;
  expectError([&] { simplified(bad, 5); }, ErrorCode::InvalidInput, "point 7");
  bad = full;
  bad.points[8][1] = std::numeric_limits<double>::quiet_NaN();
  expectError([&] { simplified(bad, 5); }, ErrorCode::InvalidInput, "point 8");
  bad = full;
  bad.radius.pop_back();
  expectError([&] { simplified(bad, 5); }, ErrorCode::InvalidInput, "624 values of radius");
  bad = full;
  bad.lines.push_back({ 3, 625 });
  expectError([&] { simplified(bad, 5); }, ErrorCode::InvalidInput,
    "point index 625 is outside [0, 624]");
}

TEST(AxisSimplification, IsRefusedForPointsAndNegativeNumbers)
{
  const TriangleMesh mesh = box({ 1.0, 0.7, 0.4 });
  MedialAxisOptions options;
  options.maxSpheres = -1;
  expectError([&] { computeMedialAxis(mesh, makeGrid(mesh.bounds(), 9), options); },
    ErrorCode::InvalidInput, "-1 is outside [0, infinity)");
  options.maxSpheres = 10;
  options.representation = Representation::Points;
  expectError([&] { computeMedialAxis(mesh, makeGrid(mesh.bounds(), 9), options); },
    ErrorCode::InvalidInput, "surface or faces");
}

TEST(AxisSimplification, ReportsProgressAndStops)
{
  const MedialAxis full = sphereSheet(1.0, 0.1);
  RecordedProgress watch;
  SimplificationOptions options;
  options.maxSpheres = 10;
  options.execution.progress = &watch;
  simplifyAxis(full, options);
  EXPECT_EQ(watch.last(), 1.0);
  RecordedProgress stop;
  stop.cancelAt = 0.35;
  options.execution.progress = &stop;
  expectError([&] { simplifyAxis(full, options); }, ErrorCode::Cancelled);
}
