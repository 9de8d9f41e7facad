#include "accuracy.h"
#include "animation.h"
#include "frame_race.h"
#include "measurement.h"
#include "memory_probe.h"
#include "meshes.h"
#include "methods/registry.h"
#include "oracle.h"
#include "output/table.h"
#include "output/target.h"
#include "output/temporary_folder.h"
#include "pairs/pair_race.h"
#include "statistics.h"

#include "support/brute_force.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

#include <cmath>

// The parts of the benchmark program must themselves be right.
namespace medial::benchmark
{
namespace
{

TEST(BenchmarkOracle, AgreesWithTheTestsBruteForce)
{
  const TriangleMesh mesh = bumpyTorus(500);
  const Oracle oracle(mesh);
  const auto points = test::randomPoints({ { -2.0, -2.0, -1.0 }, { 2.0, 2.0, 1.0 } }, 300, 1);
  const std::vector<double> distances = oracle.distances(points);
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    EXPECT_NEAR(distances[i], test::closestOnMesh(mesh, points[i]).distance, 1e-12);
  }
}

TEST(BenchmarkStatistics, Medians)
{
  EXPECT_DOUBLE_EQ(median({ 3.0, 1.0, 2.0 }), 2.0);
  EXPECT_DOUBLE_EQ(median({ 4.0, 1.0, 2.0, 3.0 }), 2.5);
  EXPECT_TRUE(std::isnan(median({})));
  EXPECT_DOUBLE_EQ(quantile({ 1.0, 5.0, 3.0 }, 1.0), 5.0);
}

TEST(BenchmarkStatistics, ExponentOfAPower)
{
  EXPECT_NEAR(fittedExponent({ { 1.0, 3.0 }, { 2.0, 24.0 }, { 4.0, 192.0 } }), 3.0, 1e-12);
  EXPECT_TRUE(std::isnan(fittedExponent({ { 1.0, 3.0 } })));
}

TEST(BenchmarkTable, Numbers)
{
  EXPECT_EQ(number(1234.5), "1234"); // halves go to even
  EXPECT_EQ(number(0.98765), "0.988");
  EXPECT_EQ(number(std::nan("")), "-");
  EXPECT_EQ(thousands(1234567), "1,234,567");
  EXPECT_EQ(thousands(999), "999");
}

TEST(BenchmarkMeshes, BumpyTorusIsClosedAndOfItsSize)
{
  for (const int triangles : { 100, 1000, 20000 })
  {
    const TriangleMesh mesh = bumpyTorus(triangles);
    EXPECT_NEAR(static_cast<double>(mesh.triangles.size()), triangles, 0.1 * triangles);
    EXPECT_EQ(mesh.points.size() * 2, mesh.triangles.size());
    EXPECT_EQ(mesh.degenerateTriangles, 0);
  }
}

TEST(BenchmarkAccuracy, FindsWrongDistancesAndLabels)
{
  const TriangleMesh mesh = test::box({ 1.0, 1.0, 1.0 });
  const Grid grid = makeGrid(mesh.bounds(), 12);
  FieldResult field = availableMethods().front().make()->compute(mesh, grid);
  AccuracyCheck check(mesh, grid, 200);
  const Accuracy right = check(field);
  EXPECT_LT(right.most(), 1e-3);
  EXPECT_EQ(right.wrongLabels, 0.0);

  for (float& distance : field.distance)
  {
    distance += static_cast<float>(0.5 * grid.spacing[0]);
  }
  std::fill(field.triangle.begin(), field.triangle.end(), 0);
  const Accuracy wrong = check(field);
  EXPECT_NEAR(wrong.most(), 0.5, 1e-3);
  EXPECT_GT(*wrong.wrongLabels, 0.5);
}

TEST(BenchmarkTarget, VerdictsAreComputed)
{
  Target target{ "mesh", "what", Target::Kind::AtLeast, 7.0, 7.5, true };
  EXPECT_EQ(target.verdict(), "met");
  target.measured = 6.9;
  EXPECT_EQ(target.verdict(), "missed");
  target.kind = Target::Kind::AtMost;
  EXPECT_EQ(target.verdict(), "met");
  target.applies = false;
  EXPECT_EQ(target.verdict(), "-");
  target = { "mesh", "what", Target::Kind::AtMost, 1.0, std::nan(""), true };
  EXPECT_EQ(target.verdict(), "-");
}

TEST(BenchmarkMemory, ProblemsPassThroughFiles)
{
  const TriangleMesh mesh = bumpyTorus(300);
  const Grid grid = makeGrid(mesh.bounds(), 17);
  const TemporaryFolder folder;
  writeProblem(folder.path() / "problem", mesh, grid);
  const Problem problem = readProblem(folder.path() / "problem");
  EXPECT_EQ(problem.mesh.points, mesh.points);
  EXPECT_EQ(problem.mesh.triangles, mesh.triangles);
  EXPECT_EQ(problem.grid.dimensions, grid.dimensions);
  EXPECT_EQ(problem.grid.origin, grid.origin);
  EXPECT_THROW(readProblem(folder.path() / "nothing"), std::runtime_error);
}

TEST(BenchmarkRounds, SlowMethodsSitThemOut)
{
  const TriangleMesh mesh = bumpyTorus(300);
  MeasurementOptions options;
  options.repeats = 3;
  options.checkedPoints = 10;
  const std::vector<MethodEntry> methods{ availableMethods().front() };
  const Grid grid = makeGrid(mesh.bounds(), 17);
  EXPECT_EQ(measureRow(mesh, grid, methods, options).runs.at(0).samples.size(), 3U);
  options.budget = 1e-9;
  const Row row = measureRow(mesh, grid, methods, options);
  EXPECT_EQ(row.runs.at(0).samples.size(), 1U);
  EXPECT_NE(secondsText(row.runs[0], row.rounds).find(", 1 run"), std::string::npos);
}

TEST(BenchmarkFrames, BothWaysAgree)
{
  const Animation animation = provideAnimation(3, 300, true);
  ASSERT_EQ(animation.frames.size(), 3U);
  EXPECT_NE(animation.frames[0], animation.frames[1]);
  const Grid grid = makeGrid(animation.bounds(), 20);
  for (const FrameTask task : { FrameTask::Field, FrameTask::Axis })
  {
    const FrameRace race = raceFrames(animation, grid, task, 2);
    EXPECT_LE(race.maxDifference, 1e-3);
    EXPECT_EQ(race.solver.samples.size(), 2U);
    EXPECT_GT(race.solver.medianSeconds(), 0.0);
    EXPECT_EQ(race.fresh.ratios.size(), 2U);
  }
}

TEST(BenchmarkPairs, ComeFromAGapUntilTheirBoxesOverlap)
{
  const TriangleMesh mesh = bumpyTorus(300);
  const MovingPair pair = deformingPair("tori", mesh, 4);
  ASSERT_EQ(pair.pointsA.size(), 4U);
  ASSERT_EQ(pair.pointsB.size(), 4U);
  EXPECT_NE(pair.pointsA[0], pair.pointsA[1]);
  for (std::size_t frame = 0; frame < 4; ++frame)
  {
    TriangleMesh a = pair.a;
    TriangleMesh b = pair.b;
    a.points = pair.pointsA[frame];
    b.points = pair.pointsB[frame];
    const Bounds boundsA = a.bounds();
    const Bounds boundsB = b.bounds();
    const double halves = 0.5 * (boundsA.max[0] - boundsA.min[0] + boundsB.max[0] - boundsB.min[0]);
    EXPECT_NEAR((boundsA.max[0] - boundsB.min[0]) / halves,
      -0.15 + 0.15 * static_cast<double>(frame), 1e-9);
    EXPECT_NEAR(boundsA.min[1] + boundsA.max[1], boundsB.min[1] + boundsB.max[1], 1e-9);
  }
}

TEST(BenchmarkPairs, DifferencesOfAnswers)
{
  PairRun truth;
  truth.answers = { { false, 0.5, 0.0, 0.0, 0 }, { true, 0.0, 0.1, 0.2, 4 } };
  PairRun run;
  run.answers = { { true, 0.25, {}, 0.5, {} }, { true, 0.0, {}, 0.1, {} } };
  const PairDifference difference = compareAnswers(run, truth);
  EXPECT_TRUE(difference.hasCollisions);
  EXPECT_EQ(difference.wrongCollisions, 1);
  EXPECT_EQ(difference.separation, 0.25);
  EXPECT_FALSE(difference.hasPointDepth);
  EXPECT_EQ(difference.depthRatio, 0.5);
}

/// All exact methods that this build has.
TEST(BenchmarkMethods, ExactOnesAreExact)
{
  for (const TriangleMesh& mesh : { bumpyTorus(400), test::lPrism(1.0, 0.7) })
  {
    const Grid grid = makeGrid(mesh.bounds(), 33);
    AccuracyCheck check(mesh, grid, 1000);
    for (const MethodEntry& entry : availableMethods())
    {
      if (entry.id == kMedialId || entry.id == kRasterId || entry.id == "embree" ||
        entry.id == "cgal" || entry.id == "vtk")
      {
        SCOPED_TRACE(entry.id);
        const Accuracy accuracy = check(entry.make()->compute(mesh, grid));
        EXPECT_GT(accuracy.errors.size(), 0U);
        EXPECT_LT(accuracy.most(), 1e-3);
        EXPECT_EQ(accuracy.wrongLabels.value_or(0.0), 0.0);
      }
    }
  }
}

} // namespace
} // namespace medial::benchmark
