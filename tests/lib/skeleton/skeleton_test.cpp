#include "medial/skeleton.h"

#include "medial/error.h"
#include "medial/simplification.h"

#include "lib/skeleton/skeleton_cases.h"
#include "support/errors.h"
#include "support/mesh_search.h"
#include "support/point_math.h"
#include "support/recorded_progress.h"
#include "support/shapes.h"
#include "support/transforms.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

using namespace medial;
using namespace medial::test;

TEST(Skeleton, HasTheComponentsAndLoopsOfTheAxis)
{
  const std::vector<TriangleMesh> meshes{
    blocks({ "#######", "#.#.#.#", "#######", "#.#.#.#", "#######" }, 0.2),
    blocks({ "#####", "#.#.#", "#####" }, 0.5),
    appended(icosphere(1.0, 3), translated(torus(1.0, 0.3, 32, 16), { 3.0, 0.2, 0.1 })),
    shell(0.6, 1.0, 3), askew(lPrism(1.0, 0.3)), ellipsoid(1.0, 0.8, 0.45, 3),
    uvCapsule(0.3, 1.2, 12)
  };
  for (const TriangleMesh& mesh : meshes)
  {
    for (const double angle : { 20.0, 60.0, 120.0, 170.0 })
    {
      const MedialAxis axis = axisOf(mesh, 56, angle);
      const CellTopology truth = topologyOf(axis);
      for (const bool smooth : { true, false })
      {
        for (const double minBranch : { 0.0, 1.0, 1000.0 })
        {
          SCOPED_TRACE(std::to_string(angle) + " " + std::to_string(minBranch));
          SkeletonOptions options;
          options.smooth = smooth;
          options.minBranch = minBranch;
          const Skeleton skeleton = computeSkeleton(axis, mesh, options);
          const CellTopology found = topologyOf(skeleton);
          EXPECT_EQ(found.components, truth.components);
          EXPECT_EQ(found.genus, truth.genus);
          EXPECT_EQ(skeleton.openedCavities, truth.cavities);
          for (std::size_t p = 0; smooth && p < skeleton.points.size(); ++p)
          {
            if (skeleton.degree[p] > 2)
            {
              EXPECT_GT(windingNumber(mesh, skeleton.points[p]), 0.5);
            }
          }
        }
      }
    }
  }
}

// The sheets of such walls are wide and bend sharply.
TEST(Skeleton, StaysWithinThinWalls)
{
  const std::string lid(20, '#');
  std::vector<std::string> rows(20, "#" + std::string(18, '.') + "#");
  rows.front() = lid;
  rows.back() = lid;
  const TriangleMesh duct = blocks(rows, 7.5);
  for (const TriangleMesh& mesh : { duct, askew(duct) })
  {
    for (const int resolution : { 100, 128 })
    {
      const Skeleton skeleton = skeletonOf(mesh, resolution);
      EXPECT_EQ(topologyOf(skeleton).genus, 1);
      ASSERT_GT(skeleton.points.size(), 50U);
      for (std::size_t p = 0; p < skeleton.points.size(); ++p)
      {
        EXPECT_GT(windingNumber(mesh, skeleton.points[p]), 0.5);
        EXPECT_GT(skeleton.radius[p], 0.25); // half of the walls' thickness is 0.5
      }
    }
  }
}

TEST(Skeleton, ArraysFitTogether)
{
  const TriangleMesh mesh = askew(unionOf(wheel(3, 1.5, 0.2), 0.1));
  const MeshSearch search(mesh);
  const Skeleton skeleton = skeletonOf(mesh, 64);
  const std::size_t count = skeleton.points.size();
  ASSERT_EQ(skeleton.radius.size(), count);
  ASSERT_EQ(skeleton.arcLength.size(), count);
  ASSERT_EQ(skeleton.degree.size(), count);
  ASSERT_EQ(skeleton.tangent.size(), count);
  std::vector<int> degree(count, 0);
  double last = std::numeric_limits<double>::infinity();
  for (const SkeletonBranch& branch : skeleton.branches)
  {
    EXPECT_LE(branch.length, last);
    last = branch.length;
    double length = 0.0;
    for (std::size_t i = 0; i < branch.points.size(); ++i)
    {
      const std::int64_t point = branch.points[i];
      EXPECT_NEAR(skeleton.radius[point], search.closest(skeleton.points[point]).distance, 1e-9);
      if (i > 0)
      {
        length += distance(skeleton.points[point], skeleton.points[branch.points[i - 1]]);
        ++degree[point];
        ++degree[branch.points[i - 1]];
      }
      if (skeleton.degree[point] > 2)
      {
        EXPECT_EQ(skeleton.arcLength[point], 0.0);
        EXPECT_EQ(skeleton.tangent[point], Point3{});
        EXPECT_TRUE(i == 0 || i + 1 == branch.points.size());
        continue;
      }
      EXPECT_NEAR(skeleton.arcLength[point], length, 1e-9);
      EXPECT_NEAR(distance(skeleton.tangent[point], Point3{}), 1.0, 1e-9);
      EXPECT_GE(skeleton.radius[point], branch.minRadius);
      EXPECT_LE(skeleton.radius[point], branch.maxRadius);
      const Point3& before = skeleton.points[branch.points[i - 1]];
      EXPECT_LT(
        degrees(angleBetween(minus(skeleton.points[point], before), skeleton.tangent[point])),
        20.0);
    }
    EXPECT_NEAR(branch.length, length, 1e-9);
    EXPECT_GE(branch.meanRadius, branch.minRadius);
    EXPECT_LE(branch.meanRadius, branch.maxRadius);
  }
  EXPECT_EQ(degree, skeleton.degree);
}

TEST(Skeleton, TurningScalingAndRefiningChangeLittle)
{
  const TriangleMesh mesh = unionOf(star({ 90, 210, 330 }, 1.5, 0.2), 0.05);
  const Skeleton truth = skeletonOf(mesh, 96);
  const auto expectSame = [&](const Skeleton& other, double scale)
  {
    ASSERT_EQ(other.branches.size(), truth.branches.size());
    for (std::size_t b = 0; b < truth.branches.size(); ++b)
    {
      const SkeletonBranch& branch = truth.branches[b];
      EXPECT_NEAR(other.branches[b].length, scale * branch.length, 0.01 * scale * branch.length);
      EXPECT_NEAR(other.branches[b].meanRadius, scale * branch.meanRadius,
        0.01 * scale * branch.meanRadius);
    }
  };
  expectSame(skeletonOf(askew(mesh), 96), 1.0);
  expectSame(skeletonOf(translated(scaled(mesh, 1e4), { 1e5, -3e5, 2e5 }), 96), 1e4);
  expectSame(skeletonOf(scaled(mesh, 1e-5), 96), 1e-5);
  expectSame(skeletonOf(subdivided(mesh, 1), 96), 1.0);
}

TEST(Skeleton, WithoutSmoothingItsPointsAreThoseOfTheAxis)
{
  const TriangleMesh mesh = askew(unionOf(star({ 90, 210, 330 }, 1.5, 0.2), 0.1));
  const MedialAxis axis = axisOf(mesh, 64);
  SkeletonOptions options;
  options.smooth = false;
  const Skeleton skeleton = computeSkeleton(axis, mesh, options);
  EXPECT_EQ(skeleton.branches.size(), 3u);
  for (const Point3& point : skeleton.points)
  {
    const double nearest = distance(*std::min_element(axis.points.begin(), axis.points.end(),
                                      [&](const Point3& a, const Point3& b)
                                      { return distance(a, point) < distance(b, point); }),
      point);
    EXPECT_LT(nearest, 1e-9);
  }
}

TEST(Skeleton, DoesNotDependOnTheNumberOfThreads)
{
  const TriangleMesh mesh = askew(unionOf(wheel(5, 1.5, 0.15), 0.1));
  const MedialAxis axis = axisOf(mesh, 64);
  SkeletonOptions options;
  options.execution.threads = 1;
  const Skeleton one = computeSkeleton(axis, mesh, options);
  options.execution.threads = 0;
  const Skeleton all = computeSkeleton(axis, mesh, options);
  EXPECT_EQ(one.points, all.points);
  EXPECT_EQ(one.radius, all.radius);
}

TEST(Skeleton, RefusesWhatHasNone)
{
  const TriangleMesh mesh = icosphere(1.0, 2);
  const MedialAxis axis = axisOf(mesh, 24);
  const auto refusal = [&](const MedialAxis& input, double minBranch = 1.0)
  {
    SkeletonOptions options;
    options.minBranch = minBranch;
    return messageOf([&] { computeSkeleton(input, mesh, options); });
  };
  EXPECT_EQ(refusal(axis, -0.5), "minimum branch length -0.5 is outside [0, infinity)");
  EXPECT_NE(refusal(axis, std::nan("")), "");
  EXPECT_NE(refusal(axis, std::numeric_limits<double>::infinity()), "");
  MedialAxis other = axis;
  other.side = Side::Exterior;
  EXPECT_NE(refusal(other).find("interior"), std::string::npos);
  other = axis;
  other.sign = SignMethod::None;
  EXPECT_NE(refusal(other).find("unsigned"), std::string::npos);
  other = axis;
  other.solid.reset();
  EXPECT_NE(refusal(other).find("topology"), std::string::npos);
  other = simplifyAxis(axis, { 10, {} });
  EXPECT_NE(refusal(other).find("simplified"), std::string::npos);
  other = axis;
  other.vertices.clear();
  other.lines.clear();
  other.quads.clear();
  EXPECT_NE(refusal(other).find("no grid point is inside"), std::string::npos);
}

TEST(Skeleton, CanBeCancelled)
{
  const TriangleMesh mesh = icosphere(1.0, 2);
  const MedialAxis axis = axisOf(mesh, 24);
  SkeletonOptions options;
  RecordedProgress stop;
  stop.maxReports = 0;
  options.execution.progress = &stop;
  expectError([&] { computeSkeleton(axis, mesh, options); }, ErrorCode::Cancelled);
}
