// Skeletons of solids whose parts face each other across narrow gaps.
#include "lib/skeleton/skeleton_cases.h"
#include "support/mesh_search.h"
#include "support/point_math.h"
#include "support/shapes.h"
#include "support/transforms.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

using namespace medial;
using namespace medial::test;

namespace
{

constexpr double kRadius = 0.5;

/// A tube of kRadius along a circle about the z axis, from an angle to another, with flat caps.
/// @param rise of its middle in a full turn.
TriangleMesh arcTube(double circle, double from, double to, double rise = 0.0)
{
  constexpr int kAround = 24;
  const int parts = static_cast<int>(std::ceil(30.0 * (to - from)));
  std::vector<Point3> points;
  std::vector<std::array<int, 3>> triangles;
  const auto add = [&](double angle, double out, double up)
  {
    points.push_back({ (circle + out) * std::cos(angle), (circle + out) * std::sin(angle),
      up + rise * angle / (2.0 * kPi) });
  };
  for (int i = 0; i <= parts; ++i)
  {
    const double angle = from + (to - from) * i / parts;
    for (int j = 0; j < kAround; ++j)
    {
      const double across = 2.0 * kPi * j / kAround;
      add(angle, kRadius * std::cos(across), kRadius * std::sin(across));
    }
  }
  add(from, 0.0, 0.0);
  add(to, 0.0, 0.0);
  const int last = kAround * parts;
  for (int j = 0; j < kAround; ++j)
  {
    const int next = (j + 1) % kAround;
    for (int i = 0; i < last; i += kAround)
    {
      triangles.push_back({ i + j, i + kAround + j, i + kAround + next });
      triangles.push_back({ i + j, i + kAround + next, i + next });
    }
    triangles.push_back({ last + kAround, j, next });
    triangles.push_back({ last + kAround + 1, last + next, last + j });
  }
  return makeMesh(points, triangles);
}

void expectWithin(const TriangleMesh& mesh, const Skeleton& skeleton, double leastRadius)
{
  for (std::size_t p = 0; p < skeleton.points.size(); ++p)
  {
    EXPECT_GT(windingNumber(mesh, skeleton.points[p]), 0.5);
    EXPECT_GT(skeleton.radius[p], leastRadius);
  }
}

} // namespace

TEST(Skeleton, BluntEndsStayOnTheirSideOfAGap)
{
  // Less than two grid points across.
  const TriangleMesh rod = cylinder(kRadius, 5.0, 24);
  for (const double gap : { 0.15, 0.05 })
  {
    SCOPED_TRACE(gap);
    const TriangleMesh rods = appended(rod, translated(rod, { 0.0, 0.0, 5.0 + gap }));
    for (const TriangleMesh& mesh : { rods, askew(rods) })
    {
      const Skeleton skeleton = skeletonOf(mesh, 128);
      ASSERT_EQ(skeleton.branches.size(), 2U);
      for (const SkeletonBranch& branch : skeleton.branches)
      {
        EXPECT_EQ(branch.kind, BranchKind::Isolated);
        EXPECT_NEAR(branch.length, 5.0 - 2.0 * kRadius, 0.05);
      }
      expectWithin(mesh, skeleton, 0.9 * kRadius);
    }
  }
}

TEST(Skeleton, AnEndDoesNotRunIntoABall)
{
  const TriangleMesh mesh = appended(icosphere(2.0, 4),
    translated(cylinder(kRadius, 5.0, 24), { 0.0, 0.0, 2.0 + 0.05 + 2.5 }));
  const Skeleton skeleton = skeletonOf(mesh, 128);
  ASSERT_EQ(skeleton.branches.size(), 2U);
  EXPECT_NEAR(skeleton.branches[0].length, 5.0 - 2.0 * kRadius, 0.05);
  EXPECT_EQ(skeleton.branches[1].length, 0.0);
  expectWithin(mesh, skeleton, 0.9 * kRadius);
}

TEST(Skeleton, TheEndsOfAnOpenRingDoNotMeet)
{
  constexpr double kCircle = 3.0;
  for (const double gap : { 0.1, 0.02 })
  {
    for (const int resolution : { 100, 128 })
    {
      SCOPED_TRACE(testing::Message() << gap << " " << resolution);
      const double half = 0.5 * gap / kCircle;
      const TriangleMesh mesh = arcTube(kCircle, half, 2.0 * kPi - half);
      const Skeleton skeleton = skeletonOf(mesh, resolution);
      ASSERT_EQ(skeleton.branches.size(), 1U);
      EXPECT_EQ(skeleton.branches.front().kind, BranchKind::Isolated);
      EXPECT_NEAR(skeleton.branches.front().length, 2.0 * kPi * kCircle - gap - 2.0 * kRadius,
        0.15);
      expectWithin(mesh, skeleton, 0.9 * kRadius);
    }
  }
}

TEST(Skeleton, TurnsOfAHelixStayApart)
{
  constexpr double kCircle = 3.0;
  constexpr double kTurns = 3.0;
  constexpr double kRise = 2.0 * kRadius + 0.01;
  const TriangleMesh mesh = arcTube(kCircle, 0.0, 2.0 * kPi * kTurns, kRise);
  for (const int resolution : { 100, 150 })
  {
    SCOPED_TRACE(resolution);
    // Voxels touch from turn to turn.
    const MedialAxis axis = axisOf(mesh, resolution);
    ASSERT_GT(axis.solid->genus, 0);
    const Skeleton skeleton = computeSkeleton(axis, mesh);
    ASSERT_EQ(skeleton.branches.size(), 1U);
    EXPECT_EQ(skeleton.branches.front().kind, BranchKind::Isolated);
    EXPECT_NEAR(skeleton.branches.front().length,
      kTurns * std::hypot(2.0 * kPi * kCircle, kRise) - 2.0 * kRadius, 0.2);
    expectWithin(mesh, skeleton, 0.9 * kRadius);
  }
}
