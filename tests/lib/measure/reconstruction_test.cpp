#include "medial/reconstruction.h"

#include "balls/ball_union.h"
#include "medial/error.h"

#include "support/errors.h"
#include "support/recorded_progress.h"

#include <gtest/gtest.h>

#include <cmath>

namespace medial::test
{
namespace
{

MedialModel bentPlate()
{
  MedialModel model;
  model.centres = { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0.3 }, { 0, 1, 0 }, { 2, 0.2, 0.1 },
    { -1, 0, 0 } };
  model.radii = { 0.2, 0.3, 0.1, 0.25, 0.15, 0.4 };
  model.quads = { { 0, 1, 2, 3 } };
  model.lines = { { 1, 4 } };
  return model;
}

TEST(Reconstruction, IsTheDistanceNearTheSurfaceAndHasTheSignElsewhere)
{
  for (const Point3& offset : { Point3{ 0, 0, 0 }, Point3{ 1e4, -2e4, 3e4 } })
  {
    MedialModel model = bentPlate();
    for (Point3& centre : model.centres)
    {
      centre = { centre[0] + offset[0], centre[1] + offset[1], centre[2] + offset[2] };
    }
    for (const bool interpolate : { true, false })
    {
      Grid grid = makeGrid(modelBounds(model), 45);
      grid.spacing[1] *= 1.5;
      const auto field = computeReconstruction(model, grid, { interpolate, {} });
      const BallUnion solid(model, interpolate);
      const double band = 3.0 * grid.spacing[1];
      std::size_t voxel = 0;
      int near = 0;
      for (int k = 0; k < grid.dimensions[2]; ++k)
      {
        for (int j = 0; j < grid.dimensions[1]; ++j)
        {
          for (int i = 0; i < grid.dimensions[0]; ++i, ++voxel)
          {
            const Point3 p = grid.point(i, j, k);
            const double exact = solid.nearest({ p[0], p[1], p[2] }).distance;
            const auto value = static_cast<double>(field[voxel]);
            if (std::abs(exact) <= band)
            {
              ++near;
              ASSERT_NEAR(value, exact, 1e-6);
            }
            else
            {
              ASSERT_EQ(value < 0.0, exact < 0.0);
              ASSERT_GE(std::abs(value), 0.99 * band);
              ASSERT_LE(std::abs(value), std::abs(exact) + 1e-6);
            }
          }
        }
      }
      EXPECT_GT(near, 1000);
      EXPECT_LT(near, static_cast<int>(field.size()) / 2);
    }
  }
}

TEST(Reconstruction, BoundsHoldAllBalls)
{
  const Bounds bounds = modelBounds(bentPlate());
  EXPECT_EQ(bounds.min[0], -1.4);
  EXPECT_EQ(bounds.max[0], 2.15);
  EXPECT_EQ(bounds.min[2], -0.4);
}

TEST(Reconstruction, CanBeCancelled)
{
  const MedialModel model = bentPlate();
  RecordedProgress progress;
  progress.cancelAt = 0.4;
  const Grid grid = makeGrid(modelBounds(model), 100);
  const ReconstructionOptions options{ true, { 0, &progress } };
  expectError([&] { computeReconstruction(model, grid, options); }, ErrorCode::Cancelled);
  EXPECT_LT(progress.last(), 1.0);
}

TEST(Reconstruction, RefusesANegativeNumberOfThreads)
{
  ReconstructionOptions options;
  options.execution.threads = -1;
  const Grid grid = makeGrid(modelBounds(bentPlate()), 10);
  EXPECT_EQ(messageOf([&] { computeReconstruction(bentPlate(), grid, options); }),
    "threads -1 is outside [0, infinity)");
}

} // namespace
} // namespace medial::test
