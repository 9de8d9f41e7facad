#include "medial/error.h"
#include "medial/skeleton_resolution.h"

#include "support/errors.h"
#include "support/recorded_progress.h"
#include "support/shapes.h"
#include "support/tubes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace medial::test
{
namespace
{

constexpr double kThin = 0.035;
/// The edges of the mesh make it thinner.
constexpr double kFacets = 0.06 * kThin;

/// A thick tube with a stub, or without one.
TriangleMesh tube(bool withStub)
{
  std::vector<Tube> tubes{ { { -1.0, 0.0, 0.0 }, { 1.0, 0.0, 0.0 }, 0.3 } };
  if (withStub)
  {
    tubes.push_back({ { 0.2, 0.0, 0.0 }, { 0.2, 0.7, 0.0 }, kThin });
  }
  return unionOf(tubes, 0.02);
}

SkeletonResolution choose(const TriangleMesh& mesh, const SkeletonOptions& options = {})
{
  return chooseSkeletonResolution(mesh, analyseConnectivity(mesh), {}, options);
}

Skeleton skeletonOf(const TriangleMesh& mesh, int resolution)
{
  MedialAxisOptions options;
  options.topology = Topology::Preserve;
  return computeSkeleton(computeMedialAxis(mesh, makeGrid(mesh.bounds(), resolution), options),
    mesh);
}

} // namespace

TEST(SkeletonResolution, IsCoarseForThickTubes)
{
  const SkeletonResolution chosen = choose(tube(false));
  EXPECT_EQ(chosen.resolution, kMinSkeletonResolution);
  EXPECT_LT(chosen.needed, kMinSkeletonResolution);
  EXPECT_NEAR(chosen.thinnestRadius, 0.3, 0.003);
  ASSERT_TRUE(chosen.skeleton);
  ASSERT_TRUE(chosen.axis);
  EXPECT_EQ(chosen.skeleton->points, skeletonOf(tube(false), chosen.resolution).points);
  EXPECT_EQ(computeSkeleton(*chosen.axis, tube(false)).points, chosen.skeleton->points);
}

TEST(SkeletonResolution, IsFineEnoughForThinBranches)
{
  const TriangleMesh mesh = tube(true);
  const SkeletonResolution chosen = choose(mesh);
  EXPECT_NEAR(chosen.thinnestRadius, kThin, kFacets);
  EXPECT_EQ(chosen.resolution, chosen.needed);
  EXPECT_FALSE(chosen.skeleton); // none was made at this resolution
  EXPECT_LT(makeGrid(mesh.bounds(), chosen.resolution).spacing[0], 0.25 * kThin);
  const Skeleton skeleton = skeletonOf(mesh, chosen.resolution);
  EXPECT_EQ(skeleton.branches.size(), 3u);
  EXPECT_NEAR(thinnestRadius(skeleton), kThin, kFacets);
}

TEST(SkeletonResolution, SaysWhenMoreIsNeeded)
{
  const SkeletonResolution chosen = choose(uvCapsule(0.012, 1.0, 24));
  EXPECT_EQ(chosen.resolution, kMaxSkeletonResolution);
  EXPECT_GT(chosen.needed, kMaxSkeletonResolution);
  EXPECT_NEAR(chosen.thinnestRadius, 0.012, 0.0006);
}

TEST(SkeletonResolution, IsTheLargestWhereTheGridsShowNothing)
{
  const SkeletonResolution chosen = choose(turned(box({ 1.0, 1.0, 1e-9 }), 0, 0.4));
  EXPECT_EQ(chosen.resolution, kMaxSkeletonResolution);
  EXPECT_TRUE(std::isinf(chosen.thinnestRadius));
}

TEST(SkeletonResolution, NeededIsTheSmallestThatIsEnough)
{
  const TriangleMesh mesh = box({ 0.3, 0.3, 2.0 });
  const Skeleton skeleton = skeletonOf(mesh, 64);
  EXPECT_NEAR(thinnestRadius(skeleton), 0.3, 0.003);
  for (const double padding : { 0.0, 0.05, 1.0 })
  {
    const int needed = neededResolution(skeleton, mesh.bounds(), padding);
    const double wanted = 0.25 * thinnestRadius(skeleton);
    EXPECT_LE(makeGrid(mesh.bounds(), needed, padding).spacing[0], wanted);
    EXPECT_GT(makeGrid(mesh.bounds(), needed - 1, padding).spacing[0], wanted);
  }
}

TEST(SkeletonResolution, RefusesWhatHasNoSkeletonAndCanBeCancelled)
{
  const TriangleMesh mesh = box({ 1.0, 1.0, 2.0 });
  expectError([] { choose(plates(0.5, 1.0), {}); }, ErrorCode::InvalidInput, "unsigned");
  SkeletonOptions wrong;
  wrong.minBranch = -1.0;
  expectError([&] { choose(mesh, wrong); }, ErrorCode::InvalidInput);
  RecordedProgress stop;
  stop.maxReports = 0;
  SkeletonOptions stopped;
  stopped.execution.progress = &stop;
  expectError([&] { choose(mesh, stopped); }, ErrorCode::Cancelled);
  EXPECT_EQ(stop.last(), 0.0);
}

} // namespace medial::test
