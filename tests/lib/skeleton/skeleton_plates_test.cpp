// Skeletons of plates and bars, in which the fire takes long ways over sheets.
#include "lib/skeleton/skeleton_cases.h"
#include "support/point_math.h"
#include "support/shapes.h"
#include "support/transforms.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

using namespace medial;
using namespace medial::test;

namespace
{

constexpr int kOrientations = 5;

/// One of some orientations that no direction of the grid is parallel to.
TriangleMesh orientated(const TriangleMesh& mesh, int orientation)
{
  return turned(turned(turned(mesh, 0, 0.4 + 0.71 * orientation), 1, 0.7 + 1.13 * orientation), 2,
    0.3 + 0.37 * orientation);
}

/// A cone whose radius falls from 1 by a third of the distance from its base.
TriangleMesh slenderCone()
{
  constexpr int kSides = 64;
  constexpr double kHeight = 2.7;
  std::vector<Point3> points{ { 0.0, 0.0, 0.0 }, { 0.0, 0.0, kHeight } };
  std::vector<std::array<int, 3>> triangles;
  for (int i = 0; i < kSides; ++i)
  {
    const double angle = 2.0 * M_PI * i / kSides;
    points.push_back({ std::cos(angle), std::sin(angle), 0.0 });
    const int next = 2 + (i + 1) % kSides;
    triangles.push_back({ 0, next, 2 + i });
    triangles.push_back({ 1, 2 + i, next });
  }
  return makeMesh(points, triangles);
}

} // namespace

/// Near its tip a cone is thinner than a voxel, whatever the grid.
TEST(Skeleton, OfASlenderConeIsALineOnCoarseGrids)
{
  const TriangleMesh cone = slenderCone();
  for (int k = 0; k < kOrientations; ++k)
  {
    for (int resolution = 18; resolution <= 24; ++resolution)
    {
      SCOPED_TRACE(testing::Message() << k << " " << resolution);
      const Skeleton skeleton = skeletonOf(orientated(cone, k), resolution);
      ASSERT_EQ(skeleton.branches.size(), 1U);
      EXPECT_GT(skeleton.branches.front().length, 1.2);
      EXPECT_LT(skeleton.branches.front().length, 2.3);
    }
  }
}

TEST(Skeleton, ThePlatesLineHasBothEnds)
{
  for (const Point3& size : { Point3{ 8.0, 4.0, 0.5 }, Point3{ 8.0, 4.0, 2.0 },
         Point3{ 10.0, 2.0, 1.0 }, Point3{ 5.0, 1.0, 0.6 }, Point3{ 20.0, 4.0, 0.6 } })
  {
    const double width = size[1];
    const TriangleMesh plate = box({ 0.5 * size[0], 0.5 * width, 0.5 * size[2] });
    for (int k = 0; k < kOrientations; ++k)
    {
      const TriangleMesh line = orientated(
        makeMesh({ { 0.5 * (width - size[0]), 0.0, 0.0 }, { 0.5 * (size[0] - width), 0.0, 0.0 } },
          {}, { { 0, 1 } }),
        k);
      for (const int resolution : { 100, 128, 200 })
      {
        SCOPED_TRACE(
          testing::Message() << size[0] << " x " << width << " " << k << " " << resolution);
        const Skeleton skeleton = skeletonOf(orientated(plate, k), resolution);
        ASSERT_EQ(skeleton.branches.size(), 1U);
        const SkeletonBranch& branch = skeleton.branches.front();
        EXPECT_NEAR(branch.length, size[0] - width, 0.15 * width);
        for (const std::int64_t end : { branch.points.front(), branch.points.back() })
        {
          const Point3& place = skeleton.points[end];
          EXPECT_LT(std::min(distance(place, line.points[0]), distance(place, line.points[1])),
            0.1 * width);
        }
      }
    }
  }
}

TEST(Skeleton, APointIsInTheMiddle)
{
  for (const Point3& half : { Point3{ 2.0, 2.0, 0.2 }, Point3{ 2.5, 2.0, 0.2 },
         Point3{ 2.0, 2.0, 0.5 }, Point3{ 2.0, 2.0, 2.0 } })
  {
    for (int k = 0; k < kOrientations; ++k)
    {
      for (const int resolution : { 100, 150 })
      {
        SCOPED_TRACE(
          testing::Message() << half[0] << " x " << half[2] << " " << k << " " << resolution);
        const Skeleton skeleton = skeletonOf(orientated(box(half), k), resolution);
        ASSERT_EQ(skeleton.points.size(), 1U);
        EXPECT_LT(length(skeleton.points.front()), 0.1);
        EXPECT_NEAR(skeleton.radius.front(), half[2], 0.001 * half[2]);
      }
    }
  }
}

TEST(Skeleton, ThePointOfADiscHasItsHalfThickness)
{
  const TriangleMesh disc = cylinder(3.02, 0.62, 64);
  for (const int resolution : { 64, 100, 128 })
  {
    for (const TriangleMesh& mesh : { disc, askew(disc) })
    {
      SCOPED_TRACE(resolution);
      const Skeleton skeleton = skeletonOf(mesh, resolution);
      ASSERT_EQ(skeleton.points.size(), 1U);
      EXPECT_LT(length(skeleton.points.front()), 0.15);
      EXPECT_NEAR(skeleton.radius.front(), 0.31, 0.001);
    }
  }
}
