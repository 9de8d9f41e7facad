#include "medial/field_proximity.h"

#include "medial/error.h"
#include "medial/proximity.h"
#include "support/shapes.h"
#include "support/transforms.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace
{

using medial::FieldProximity;
using medial::FieldProximityOptions;
using medial::FieldProximitySolver;
using medial::TriangleMesh;
using medial::test::box;
using medial::test::icosphere;
using medial::test::translated;

double diagonal(const FieldProximity& result)
{
  return std::sqrt(3.0) * result.grid.spacing[0];
}

/// Expects an error for bad input whose message has a text.
template <typename Work>
void expectRefused(const Work& work, const std::string& text)
{
  try
  {
    work();
    FAIL() << "no error about " << text;
  }
  catch (const medial::Error& error)
  {
    EXPECT_EQ(error.code(), medial::ErrorCode::InvalidInput);
    EXPECT_NE(std::string(error.what()).find(text), std::string::npos) << error.what();
  }
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

TEST(FieldProximity, RefusesWhatItCannotCompute)
{
  const TriangleMesh cube = box({ 1.0, 1.0, 1.0 });
  expectRefused([&] { FieldProximitySolver(cube, TriangleMesh()); }, "mesh 1 is empty");
  FieldProximitySolver solver(cube, cube);
  FieldProximityOptions options;
  options.resolution = 1;
  expectRefused([&] { solver.compute(options); }, "resolution 1");
  expectRefused([&] { solver.setPoints(2, cube.points); }, "no mesh 2");
}

} // namespace
