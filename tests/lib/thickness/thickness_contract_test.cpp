// What holds for the thickness of every mesh, compared with brute force.
#include "medial/thickness.h"

#include "medial/error.h"

#include "support/brute_force.h"
#include "support/errors.h"
#include "support/models.h"
#include "support/recorded_progress.h"
#include "support/shapes.h"
#include "support/thickness_oracle.h"
#include "support/transforms.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

using namespace medial;
using namespace medial::test;

namespace
{

/// An uneven, wavy closed surface.
TriangleMesh lump(int subdivisions)
{
  TriangleMesh mesh = icosphere(1.0, subdivisions);
  for (Point3& p : mesh.points)
  {
    const double radius =
      1.0 + 0.25 * std::sin(3.0 * p[0] + 0.4) * std::cos(4.0 * p[1]) + 0.15 * std::sin(5.0 * p[2]);
    p = { 1.3 * radius * p[0], radius * p[1], 0.7 * radius * p[2] };
  }
  return mesh;
}

/// Compares `count` points, spread over the mesh, with brute force. Points whose value is 0 by the
/// rule for sharp edges and tips are skipped; returns their number.
int compare(const TriangleMesh& mesh, const ThicknessOptions& options, int count)
{
  const Thickness thickness = computeThickness(mesh, options);
  const std::vector<Point3> normals = pointNormals(mesh);
  const double sign = options.side == Side::Exterior ? 1.0 : -1.0;
  const double diagonal = mesh.bounds().diagonal();
  const std::size_t step = std::max<std::size_t>(1, mesh.points.size() / count);
  std::vector<std::size_t> points;
  for (std::size_t i = 0; i < mesh.points.size(); i += step)
  {
    points.push_back(i);
  }
  const MeshSearch search(mesh);
  std::vector<double> expected(points.size());
  parallelFor(points.size(),
    [&](std::size_t i)
    {
      const Point3& n = normals[points[i]];
      const Point3 direction{ sign * n[0], sign * n[1], sign * n[2] };
      expected[i] = n == Point3{} ? std::numeric_limits<double>::quiet_NaN()
                                  : thicknessByBruteForce(search, mesh.points[points[i]], direction,
                                      options.angle, 1e-5 * diagonal);
    });
  int sharp = 0;
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    const auto value = static_cast<double>(thickness.values[points[i]]);
    if (value == 0.0)
    {
      ++sharp;
      continue;
    }
    EXPECT_EQ(std::isnan(value), std::isnan(expected[i])) << "point " << points[i];
    if (!std::isnan(value))
    {
      EXPECT_NEAR(value, expected[i], 1e-6 * diagonal) << "point " << points[i];
    }
  }
  return sharp;
}

ThicknessOptions optionsOf(double angle, Side side)
{
  ThicknessOptions options;
  options.angle = angle;
  options.side = side;
  return options;
}

} // namespace

TEST(ThicknessContract, AgreesWithBruteForceOnALump)
{
  EXPECT_EQ(compare(lump(3), optionsOf(60.0, Side::Interior), 60), 0);
  EXPECT_LE(compare(lump(3), optionsOf(30.0, Side::Interior), 60), 20);
  EXPECT_EQ(compare(lump(3), optionsOf(120.0, Side::Interior), 60), 0);
  EXPECT_EQ(compare(lump(3), optionsOf(60.0, Side::Exterior), 60), 0);
}

TEST(ThicknessContract, AgreesWithBruteForceOnShapesAndSoups)
{
  EXPECT_LE(compare(subdivided(lPrism(1.0, 0.6), 3), optionsOf(60.0, Side::Interior), 150), 100);
  EXPECT_LE(compare(shell(0.6, 1.0, 2), optionsOf(60.0, Side::Interior), 80), 20);
  EXPECT_LE(compare(randomSoup(40, 7), optionsOf(60.0, Side::Interior), 120), 60);
  EXPECT_LE(compare(randomSoup(40, 7), optionsOf(60.0, Side::Exterior), 120), 60);
}

TEST(ThicknessContract, AgreesWithBruteForceOnRealMeshes)
{
  for (const char* name : { "organic/elephant_5.6k.off", "cad/joint_446.off" })
  {
    const auto path = modelPath(name);
    const TriangleMesh mesh = path ? buildTriangleMesh(loadModel(*path)) : lump(2);
    compare(mesh, optionsOf(60.0, Side::Interior), 60);
  }
}

TEST(ThicknessContract, IsTheSameForAnyNumberOfThreads)
{
  const TriangleMesh mesh = lump(4);
  ThicknessOptions options;
  const Thickness all = computeThickness(mesh, options);
  options.execution.threads = 1;
  EXPECT_EQ(computeThickness(mesh, options).values, all.values);
}

TEST(ThicknessContract, GoesWithTheMesh)
{
  const TriangleMesh mesh = lump(2);
  const std::vector<float> values = computeThickness(mesh).values;
  const std::vector<float> moved = computeThickness(translated(mesh, { 1e4, -1e4, 1e4 })).values;
  const std::vector<float> small = computeThickness(scaled(mesh, 1e-6)).values;
  const std::vector<float> large = computeThickness(scaled(mesh, 1e6)).values;
  const std::vector<float> turned = computeThickness(rotated90(mesh, 1)).values;
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    ASSERT_NEAR(moved[i], values[i], 1e-6);
    ASSERT_NEAR(1e6f * small[i], values[i], 1e-6);
    ASSERT_NEAR(1e-6f * large[i], values[i], 1e-6);
    ASSERT_NEAR(turned[i], values[i], 1e-6);
  }
}

TEST(ThicknessContract, ClosedMeshesThatFaceInwardsAreTurnedRound)
{
  const TriangleMesh mesh = subdivided(box({ 1.0, 0.7, 0.4 }), 2);
  EXPECT_EQ(computeThickness(flipOrientation(mesh)).values, computeThickness(mesh).values);
}

TEST(ThicknessContract, SummaryIsThatOfTheValues)
{
  const TriangleMesh mesh = torus(1.0, 0.3, 24, 12);
  const Thickness thickness = computeThickness(mesh, optionsOf(60.0, Side::Exterior));
  std::vector<float> present;
  for (const float value : thickness.values)
  {
    if (!std::isnan(value))
    {
      present.push_back(value);
    }
  }
  std::sort(present.begin(), present.end());
  ASSERT_FALSE(present.empty());
  EXPECT_EQ(thickness.values.size(), mesh.points.size());
  EXPECT_EQ(thickness.without, static_cast<std::int64_t>(mesh.points.size() - present.size()));
  EXPECT_EQ(thickness.min, present.front());
  const auto smaller =
    std::lower_bound(present.begin(), present.end(), static_cast<float>(thickness.percentile5));
  EXPECT_EQ(static_cast<double>(*smaller), thickness.percentile5);
  EXPECT_LE(20 * (smaller - present.begin()), static_cast<std::ptrdiff_t>(present.size()));
  EXPECT_EQ(thickness.median, present[present.size() / 2]);
  const auto larger =
    std::upper_bound(present.begin(), present.end(), static_cast<float>(thickness.percentile95));
  EXPECT_EQ(static_cast<double>(*(larger - 1)), thickness.percentile95);
  EXPECT_LE(20 * (present.end() - larger), static_cast<std::ptrdiff_t>(present.size()));
  EXPECT_EQ(thickness.max, present.back());
}

// A point without a normal has no ball, but it limits the balls of others.
TEST(ThicknessContract, SegmentsAndPointsLimitBallsAndHaveNone)
{
  TriangleMesh mesh =
    makeMesh({ { -9.0, -9.0, 0.0 }, { 9.0, -9.0, 0.0 }, { 0.0, 9.0, 0.0 }, { 0.0, 0.0, 0.0 },
               { 0.0, 0.0, -1.0 }, { 5.0, 5.0, -7.0 }, { 6.0, 5.0, -7.0 } },
      { { 0, 1, 3 }, { 1, 2, 3 }, { 2, 0, 3 } }, { { 5, 6 } }, { 4 });
  const Thickness thickness = computeThickness(mesh);
  EXPECT_NEAR(thickness.values[3], 1.0, 1e-6);
  EXPECT_TRUE(std::isnan(thickness.values[4]));
  EXPECT_TRUE(std::isnan(thickness.values[5]));
}

TEST(ThicknessContract, TwoSidesOfOneSheetHaveNone)
{
  const TriangleMesh mesh = makeMesh({ { 0.0, 0.0, 0.0 }, { 1.0, 0.0, 0.0 }, { 0.0, 1.0, 0.0 } },
    { { 0, 1, 2 }, { 0, 2, 1 } });
  EXPECT_EQ(computeThickness(mesh).without, 3);
}

TEST(ThicknessContract, OddInputsPassWithoutHarm)
{
  EXPECT_TRUE(std::isnan(computeThickness(makeMesh({ { 1.0, 2.0, 3.0 } }, {}, {}, { 0 })).min));
  EXPECT_EQ(computeThickness(makeMesh({ { 0.0, 0.0, 0.0 }, { 1.0, 0.0, 0.0 }, { 2.0, 0.0, 0.0 } },
                               { { 0, 1, 2 } }))
              .without,
    3);
}

TEST(ThicknessContract, RefusesWhatIsOutsideItsRange)
{
  const TriangleMesh mesh = box({ 1.0, 1.0, 1.0 });
  for (const double angle : { 0.0, 180.0, -1.0, std::nan("") })
  {
    expectError([&] { computeThickness(mesh, optionsOf(angle, Side::Interior)); },
      ErrorCode::InvalidInput, "(0, 180)");
  }
  ThicknessOptions options;
  options.execution.threads = -2;
  expectError([&] { computeThickness(mesh, options); }, ErrorCode::InvalidInput, "-2");
  expectError([] { computeThickness(TriangleMesh{}); }, ErrorCode::InvalidInput, "no cells");
}

TEST(ThicknessContract, ReportsProgressAndStops)
{
  const TriangleMesh mesh = lump(4);
  RecordedProgress listener;
  ThicknessOptions options;
  options.side = Side::Both;
  options.execution.progress = &listener;
  computeThickness(mesh, options);
  EXPECT_EQ(listener.fractions.front(), 0.0);
  EXPECT_EQ(listener.fractions.back(), 1.0);
  ASSERT_GE(listener.fractions.size(), 8u);
  for (const std::size_t at : { std::size_t{ 1 }, listener.fractions.size() / 2 })
  {
    RecordedProgress stopper;
    stopper.maxReports = at;
    options.execution.progress = &stopper;
    expectError([&] { computeThickness(mesh, options); }, ErrorCode::Cancelled, "cancelled");
    EXPECT_EQ(stopper.fractions.size(), at);
  }
}
