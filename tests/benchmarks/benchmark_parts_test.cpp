#include "accuracy.h"
#include "meshes.h"
#include "methods/registry.h"
#include "oracle.h"
#include "output/table.h"
#include "statistics.h"

#include "support/brute_force.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

#include <cmath>

// The parts of the benchmark program: what measures must itself be right.
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

/// Whatever was found at configuration: those that are exact by design.
TEST(BenchmarkMethods, ExactOnesAreExact)
{
  for (const TriangleMesh& mesh : { bumpyTorus(400), test::lPrism(1.0, 0.7) })
  {
    const Grid grid = makeGrid(mesh.bounds(), 33);
    AccuracyCheck check(mesh, grid, 1000);
    for (const MethodEntry& entry : availableMethods())
    {
      if (entry.id == kMedialId || entry.id == "embree" || entry.id == "cgal" || entry.id == "vtk")
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
