#include "medial/field_proximity.h"

#include "medial/compute_distance_field.h"
#include "medial/error.h"
#include "medial/proximity.h"
#include "support/errors.h"
#include "support/shapes.h"
#include "support/transforms.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

namespace
{

using medial::FieldProximity;
using medial::FieldProximityOptions;
using medial::FieldProximitySolver;
using medial::TriangleMesh;
using medial::test::box;
using medial::test::expectError;
using medial::test::icosphere;
using medial::test::translated;

double diagonal(const FieldProximity& result)
{
  return std::sqrt(3.0) * result.grid.spacing[0];
}

TEST(FieldProximity, AgreesWithTheExactAnswers)
{
  const TriangleMesh ball = icosphere(1.0, 3);
  const TriangleMesh brick = box({ 0.7, 0.9, 1.1 });
  FieldProximitySolver solver(ball, brick);
  for (const double shift : { 2.5, 1.8, 1.3, 0.8 })
  {
    SCOPED_TRACE(shift);
    const TriangleMesh moved = translated(brick, { shift, 0.3, -0.2 });
    solver.setPoints(1, moved.points);
    const FieldProximity fields = solver.compute();
    const medial::Proximity exact = medial::computeProximity(ball, moved);
    EXPECT_EQ(fields.collide, exact.collide);
    EXPECT_GE(fields.separation, exact.separation - 1e-6);
    EXPECT_LE(fields.separation, exact.separation + diagonal(fields));
    EXPECT_NEAR(fields.depth, exact.depth, diagonal(fields));
    EXPECT_LE(fields.commonDepth, exact.translationalDepth.upper + 1e-6);
  }
}

TEST(FieldProximity, OfBoxesThatOverlapIsTheirDepth)
{
  const TriangleMesh cube = box({ 1.0, 1.0, 1.0 });
  FieldProximitySolver solver(cube, translated(cube, { 0.5, 0.0, 0.0 }));
  const FieldProximity result = solver.compute();
  EXPECT_TRUE(result.collide);
  EXPECT_NEAR(result.depth, 0.5, diagonal(result));
  EXPECT_NEAR(result.commonDepth, 1.5, diagonal(result));
  EXPECT_NEAR(result.overlapVolume, 6.0, 0.5);
}

struct Sums
{
  std::int64_t inBoth = 0;
  double separation = std::numeric_limits<double>::infinity();
  double commonDepth = 0.0;
};

/// What the whole fields of two meshes on a grid tell.
Sums sumsOfWholeFields(const TriangleMesh& a, const TriangleMesh& b, const medial::Grid& grid)
{
  const std::vector<float> ofA = medial::computeDistanceField(a, grid).distance;
  const std::vector<float> ofB = medial::computeDistanceField(b, grid).distance;
  Sums sums;
  for (std::size_t i = 0; i < ofA.size(); ++i)
  {
    const double sum = static_cast<double>(ofA[i]) + static_cast<double>(ofB[i]);
    if (ofA[i] < 0.0F && ofB[i] < 0.0F)
    {
      ++sums.inBoth;
      sums.commonDepth = std::max(sums.commonDepth, -sum);
    }
    else if (ofA[i] >= 0.0F && ofB[i] >= 0.0F)
    {
      sums.separation = std::min(sums.separation, sum);
    }
  }
  return sums;
}

// Fine grids are computed in part only. Nothing of what is left out may be missed, to the last bit.
TEST(FieldProximity, MissesNothingOfFineGrids)
{
  const TriangleMesh ball = icosphere(1.0, 3);
  const TriangleMesh brick = box({ 0.7, 0.9, 1.1 });
  TriangleMesh open = brick;
  open.triangles.pop_back();
  open.triangleCells.pop_back();
  FieldProximityOptions options;
  options.resolution = 200;
  for (const TriangleMesh& other : { brick, open })
  {
    for (const double shift : { 2.4, 1.62, 1.55, 0.9 })
    {
      SCOPED_TRACE(shift);
      const TriangleMesh moved = translated(other, { shift, 0.35, -0.45 });
      const FieldProximity result = FieldProximitySolver(ball, moved).compute(options);
      const Sums whole = sumsOfWholeFields(ball, moved, result.grid);
      const double cell = std::pow(result.grid.spacing[0], 3);
      EXPECT_EQ(result.collide, whole.inBoth > 0);
      EXPECT_NEAR(result.overlapVolume / cell, static_cast<double>(whole.inBoth), 0.5);
      EXPECT_EQ(result.commonDepth, whole.commonDepth);
      EXPECT_EQ(result.separation, result.collide ? 0.0 : whole.separation);
    }
  }
}

TEST(FieldProximity, RefusesWhatItCannotCompute)
{
  const TriangleMesh cube = box({ 1.0, 1.0, 1.0 });
  expectError([&] { FieldProximitySolver(cube, TriangleMesh()); }, medial::ErrorCode::InvalidInput,
    "mesh 1: the mesh has no cells");
  FieldProximitySolver solver(cube, cube);
  FieldProximityOptions options;
  options.resolution = 1;
  expectError([&] { solver.compute(options); }, medial::ErrorCode::InvalidInput, "resolution 1");
  expectError([&] { solver.setPoints(2, cube.points); }, medial::ErrorCode::InvalidInput,
    "no mesh 2");
}

} // namespace
