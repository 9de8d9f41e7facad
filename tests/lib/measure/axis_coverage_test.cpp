// Shares of surfaces that are known from their areas.
#include "medial/axis_coverage.h"

#include "medial/error.h"
#include "support/axes.h"
#include "support/errors.h"
#include "support/recorded_progress.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <string>

namespace medial::test
{
namespace
{

const double kPi = std::acos(-1.0);
constexpr double kReach = 0.03;

double uncovered(const TriangleMesh& mesh, const MedialModel& model, double reach = kReach)
{
  return measureCoverage(mesh, model, reach).uncoveredShare;
}

TEST(AxisCoverage, TheAxisOfACapsuleLeavesNothing)
{
  MedialModel model = capsuleModel(1.0, 0.5);
  const TriangleMesh mesh = uvCapsule(0.5, 1.0, 128);
  const AxisCoverage coverage = measureCoverage(mesh, model, 1e-4);
  EXPECT_EQ(coverage.uncoveredShare, 0.0);
  EXPECT_EQ(coverage.reach, 1e-4);
  EXPECT_EQ(coverage.samples, kDefaultCoverageSamples);
  // Without the line the cylinder is uncovered except beside the balls.
  model.lines.clear();
  const double beside = std::sqrt(kReach * kReach + 2.0 * kReach * 0.5);
  EXPECT_NEAR(uncovered(mesh, model), (1.0 - beside) / (1.0 + 0.5), 0.002);
}

// Two caps of a capsule, the lower one smaller, stick out of a cone between its balls.
TEST(AxisCoverage, PlacesAreWhereItIsLeftOut)
{
  const AxisCoverage coverage =
    measureCoverage(uvCapsule(0.5, 1.0, 128), ballModel(0.5, { 0, 0, 0.2 }), 0.03);
  ASSERT_EQ(coverage.places.size(), 2U);
  EXPECT_LT(coverage.places[0].point[2], -0.2);
  EXPECT_GT(coverage.places[1].point[2], 0.5);
  EXPECT_GT(coverage.places[0].share, coverage.places[1].share);
  EXPECT_NEAR(coverage.places[0].share + coverage.places[1].share, coverage.uncoveredShare, 1e-12);
}

TEST(AxisCoverage, ANegligibleShareIsBounded)
{
  MedialModel model;
  for (int i = 0; i <= 200; ++i)
  {
    model.centres.push_back({ 0, 0, -1 + 0.01 * i });
    model.radii.push_back(0.5);
  }
  model.centres.push_back({ 0, 0, 0 });
  model.radii.push_back(0.1);
  const TriangleMesh mesh = uvCapsule(0.5, 1.0, 128);
  CoverageOptions options;
  const auto share = [&] { return measureCoverage(mesh, model, 1e-3, options).uncoveredShare; };
  const double exact = share();
  for (const double negligible : { 0.001, 0.01, 0.1, 0.9, 1.0 })
  {
    options.negligible = negligible;
    const double bound = share();
    EXPECT_GE(bound, exact);
    EXPECT_TRUE(bound == exact || bound < negligible) << bound;
  }
  for (const double wrong : { -0.1, 1.1, std::numeric_limits<double>::quiet_NaN() })
  {
    options.negligible = wrong;
    EXPECT_THROW(share(), Error);
  }
}

TEST(AxisCoverage, DefaultIsTheSameHoweverItIsMade)
{
  const TriangleMesh mesh = icosphere(1.0, 2);
  EXPECT_EQ(CoverageOptions().samples, kDefaultCoverageSamples);
  const AxisCoverage expected = measureCoverage(mesh, ballModel(0.9), kReach);
  for (const CoverageOptions& options : { CoverageOptions(), CoverageOptions{} })
  {
    const AxisCoverage coverage = measureCoverage(mesh, ballModel(0.9), kReach, options);
    EXPECT_EQ(coverage.samples, expected.samples);
    EXPECT_EQ(coverage.uncoveredShare, expected.uncoveredShare);
  }
}

TEST(AxisCoverage, ABodyWithoutAxisCountsByItsArea)
{
  const TriangleMesh one = icosphere(1.0, 4);
  const TriangleMesh mesh = appended(one, translated(scaled(one, 0.25), { 4.0, 0.0, 0.0 }));
  EXPECT_NEAR(uncovered(mesh, ballModel(1.0)), 0.0625 / 1.0625, 0.0005);
}

/// The middle sheet of a box alone, as a theta of more than 90 degrees leaves it: around the places
/// that its balls touch, whatever is nearer to it than radius + reach.
TEST(AxisCoverage, ABoxWithoutTheSheetsOfItsEdges)
{
  const Point3 half{ 1.0, 0.8, 0.5 };
  const double u = half[0] - half[2];
  const double v = half[1] - half[2];
  AxisBuilder sheet;
  sheet.addSheet({ -u, -v, 0.0 }, { 2.0 * u, 0.0, 0.0 }, { 0.0, 2.0 * v, 0.0 }, 4, half[2]);
  const double around = std::sqrt(kReach * kReach + 2.0 * kReach * half[2]);
  const double disc = kPi * around * around;
  const double covered = 2.0 * (4.0 * u * v + 4.0 * (u + v) * around + disc) // top and bottom
    + 2.0 * (4.0 * v * around + disc) + 2.0 * (4.0 * u * around + disc);
  const double area = 8.0 * (half[0] * half[1] + half[1] * half[2] + half[2] * half[0]);
  EXPECT_NEAR(uncovered(box(half), toMedialModel(sheet.axis)), 1.0 - covered / area, 0.001);
}

/// The innermost line of a wedge alone, as a theta above the angles of all its edges leaves it: the
/// cylinder along it touches the middles of the three flanks and fills the incircles of the ends.
TEST(AxisCoverage, AWedgeWithoutTheSheetsOfItsEdges)
{
  const double length = 3.0;
  const double apex = 35.0 * kPi / 180.0; // half of it; the two flanks there are 1 wide
  const double perimeter = 2.0 + 2.0 * std::sin(apex);
  const double end = std::sin(apex) * std::cos(apex);
  const double radius = 2.0 * end / perimeter;
  MedialModel line;
  const double x = radius / std::sin(apex);
  line.centres = { { x, 0.0, -0.5 * length }, { x, 0.0, 0.5 * length } };
  line.radii = { radius, radius };
  line.lines = { { 0, 1 } };
  const double outer = radius + kReach;
  const double half = std::sqrt(outer * outer - radius * radius);
  const double beyondFlank = outer * outer * std::acos(radius / outer) - radius * half;
  const double covered =
    3.0 * 2.0 * half * length + 2.0 * (kPi * outer * outer - 3.0 * beyondFlank);
  const double area = perimeter * length + 2.0 * end;
  EXPECT_NEAR(uncovered(wedge(70.0, length, 1.0), line), 1.0 - covered / area, 0.001);
}

TEST(AxisCoverage, WhatIsInsideTheUnionIsCovered)
{
  EXPECT_EQ(uncovered(icosphere(1.0, 3), ballModel(5.0), 0.0), 0.0);
  EXPECT_EQ(uncovered(icosphere(1.0, 3), ballModel(0.5), 0.4), 1.0);
  EXPECT_EQ(uncovered(icosphere(1.0, 3), ballModel(0.5), 0.501), 0.0);
}

TEST(AxisCoverage, NoBallsCoverNothingAndNoAreaNeedsNone)
{
  EXPECT_EQ(uncovered(icosphere(1.0, 1), {}), 1.0);
  const TriangleMesh segment = makeMesh({ { 0, 0, 0 }, { 1, 0, 0 } }, {}, { { 0, 1 } });
  EXPECT_EQ(uncovered(segment, ballModel(0.1)), 0.0);
  EXPECT_EQ(uncovered(segment, {}), 0.0);
}

TEST(AxisCoverage, ThreadsDoNotChangeTheResult)
{
  const TriangleMesh mesh = lPrism(1.0, 0.4);
  CoverageOptions options;
  options.samples = 5000;
  options.execution.threads = 1;
  const double one = measureCoverage(mesh, ballModel(0.6), kReach, options).uncoveredShare;
  options.execution.threads = 2;
  EXPECT_EQ(measureCoverage(mesh, ballModel(0.6), kReach, options).uncoveredShare, one);
  EXPECT_GT(one, 0.0);
  EXPECT_LT(one, 1.0);
}

TEST(AxisCoverage, RefusesWhatItCannotMeasure)
{
  const TriangleMesh mesh = icosphere(1.0, 1);
  for (const double reach :
    { -0.5, std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity() })
  {
    expectError([&] { measureCoverage(mesh, ballModel(1.0), reach); }, ErrorCode::InvalidInput,
      "outside [0, infinity)");
  }
  expectError([&] { uncovered(mesh, ballModel(-1.0)); }, ErrorCode::InvalidInput, "radius -1");
  expectError(
    [&]
    {
      CoverageOptions options;
      options.samples = 10;
      measureCoverage(mesh, ballModel(1.0), kReach, options);
    },
    ErrorCode::InvalidInput, "number of samples 10 is outside [1000, 100000000]");
  expectError(
    [&]
    {
      CoverageOptions options;
      options.execution.threads = -1;
      measureCoverage(mesh, ballModel(1.0), kReach, options);
    },
    ErrorCode::InvalidInput, "threads -1 is outside [0, infinity)");
}

TEST(AxisCoverage, CanBeCancelled)
{
  RecordedProgress stop;
  stop.maxReports = 0;
  CoverageOptions options;
  options.execution.progress = &stop;
  expectError([&] { measureCoverage(icosphere(1.0, 1), ballModel(1.0), kReach, options); },
    ErrorCode::Cancelled, "cancelled");
}

} // namespace
} // namespace medial::test
