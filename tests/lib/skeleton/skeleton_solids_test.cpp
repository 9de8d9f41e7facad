// Skeletons of solids whose network is known.
#include "lib/skeleton/skeleton_cases.h"
#include "support/mesh_search.h"
#include "support/model_formats.h"
#include "support/models.h"
#include "support/named.h"
#include "support/point_math.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <limits>
#include <string>
#include <utility>
#include <vector>

using namespace medial;
using namespace medial::test;

namespace
{

std::vector<Point3> placesOf(const Skeleton& skeleton, const SkeletonBranch& branch)
{
  std::vector<Point3> places;
  for (const std::int64_t point : branch.points)
  {
    places.push_back(skeleton.points[point]);
  }
  return places;
}

/// A solid whose network is known.
struct SolidCase
{
  TriangleMesh mesh;
  std::vector<std::size_t> branches; ///< of each kind
  std::int64_t junctions;
  double length; ///< of the first branch; NaN if it is not known
  double radius; ///< mean of the first branch; NaN if it is not known
};

constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

std::vector<Named<SolidCase>> cases()
{
  const auto one = [](BranchKind kind)
  {
    std::vector<std::size_t> counts(4, 0);
    counts[static_cast<std::size_t>(kind)] = 1;
    return counts;
  };
  return {
    { "capsule",
      [=] {
        return SolidCase{ askew(uvCapsule(0.3, 2.0, 64)), one(BranchKind::Isolated), 0, 4.0, 0.3 };
      } },
    { "cylinder",
      [=] {
        return SolidCase{ askew(cylinder(0.3, 4.0, 64)), one(BranchKind::Isolated), 0, 3.4, 0.3 };
      } },
    { "squareBeam",
      [=] {
        return SolidCase{ askew(box({ 2.0, 0.25, 0.25 })), one(BranchKind::Isolated), 0, 3.5,
          0.25 };
      } },
    { "openTube",
      [=] {
        return SolidCase{ askew(openTube(0.3, 4.0, 64)), one(BranchKind::Isolated), 0, 4.0, 0.3 };
      } },
    { "torus",
      [=]
      {
        return SolidCase{ turned(torus(1.0, 0.2, 128, 64), 0, 0.4), one(BranchKind::Closed), 0,
          2.0 * kPi, 0.2 };
      } },
    { "Y",
      []
      {
        return SolidCase{ askew(unionOf(star({ 90, 210, 330 }, 1.5, 0.2), 0.05)), { 3, 0, 0, 0 }, 1,
          1.5, kUnknown };
      } },
    { "T",
      []
      {
        return SolidCase{ askew(unionOf(star({ 0, 180, 270 }, 1.5, 0.2), 0.05)), { 3, 0, 0, 0 }, 1,
          1.5, kUnknown };
      } },
    { "X",
      []
      {
        return SolidCase{ askew(unionOf(star({ 0, 90, 180, 270 }, 1.5, 0.2), 0.05)), { 4, 0, 0, 0 },
          1, 1.5, kUnknown };
      } },
    { "obliqueX",
      []
      {
        return SolidCase{ askew(unionOf(star({ 0, 60, 180, 240 }, 1.5, 0.2), 0.05)), { 4, 0, 0, 0 },
          1, 1.5, kUnknown };
      } },
    { "wheel",
      []
      {
        return SolidCase{ askew(unionOf(wheel(5, 1.5, 0.15), 0.06)), { 0, 10, 0, 0 }, 6,
          1.5 * 0.4 * kPi, kUnknown };
      } },
    { "plate",
      [=]
      {
        return SolidCase{ askew(box({ 2.0, 0.7, 0.1 })), one(BranchKind::Isolated), 0, kUnknown,
          0.1 };
      } },
    { "cube",
      [=] {
        return SolidCase{ askew(box({ 1.0, 1.0, 1.0 })), one(BranchKind::Isolated), 0, 0.0, 1.0 };
      } },
    { "ball",
      [=] {
        return SolidCase{ icosphere(1.0, 4), one(BranchKind::Isolated), 0, 0.0, 1.0 };
      } }
  };
}

void expectNetwork(const Skeleton& skeleton, const SolidCase& truth)
{
  for (std::size_t kind = 0; kind < 4; ++kind)
  {
    EXPECT_EQ(skeleton.count(static_cast<BranchKind>(kind)), truth.branches[kind]) << kind;
  }
  EXPECT_EQ(skeleton.junctions(), truth.junctions);
  const SkeletonBranch& first = skeleton.branches.front();
  if (!std::isnan(truth.length))
  {
    EXPECT_NEAR(first.length, truth.length, 0.01 * truth.length);
  }
  if (!std::isnan(truth.radius))
  {
    EXPECT_NEAR(first.meanRadius, truth.radius, 0.01 * truth.radius);
  }
}

class SkeletonOfSolid : public testing::TestWithParam<Named<SolidCase>>
{
};

} // namespace

TEST_P(SkeletonOfSolid, HasItsBranchesJunctionsAndLengths)
{
  const SolidCase input = GetParam().make();
  // More of both take minutes.
  const char* wanted = std::getenv("MEDIAL_SKELETON_ORIENTATIONS");
  const int orientations = wanted != nullptr ? std::atoi(wanted) : 1;
  const std::vector<int> resolutions =
    wanted != nullptr ? std::vector<int>{ 96, 128, 256 } : std::vector<int>{ 96, 128 };
  for (int k = 0; k < orientations; ++k)
  {
    SCOPED_TRACE(k);
    const TriangleMesh mesh =
      turned(turned(turned(input.mesh, 0, 0.37 * k), 1, 1.13 * k), 2, 0.71 * k);
    for (const int resolution : resolutions)
    {
      SCOPED_TRACE(resolution);
      expectNetwork(skeletonOf(mesh, resolution), input);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Solids, SkeletonOfSolid, testing::ValuesIn(cases()), kNameOfParameter);

TEST(Skeleton, RunsStraightThroughTheMiddleOfAStraightTube)
{
  constexpr int kResolution = 96;
  for (const TriangleMesh& tube :
    { uvCapsule(0.3, 2.0, 64), cylinder(0.3, 4.0, 64), box({ 0.3, 0.3, 2.0 }) })
  {
    const TriangleMesh mesh = askew(tube);
    const double step = makeGrid(mesh.bounds(), kResolution).spacing[0];
    const Skeleton skeleton = skeletonOf(mesh, kResolution);
    ASSERT_EQ(skeleton.branches.size(), 1u);
    const std::vector<Point3> line = placesOf(skeleton, skeleton.branches.front());
    EXPECT_LT(turning(line), 10.0);
    const TriangleMesh axis =
      askew(makeMesh({ { 0.0, 0.0, -2.0 }, { 0.0, 0.0, 2.0 } }, {}, { { 0, 1 } }));
    for (const Point3& point : line)
    {
      EXPECT_LT(distance(closestOnMesh(axis, point).point, point), 0.1 * step);
    }
  }
}

TEST(Skeleton, JunctionsLieWhereTheTubesCross)
{
  const std::vector<std::vector<double>> stars{ { 90, 210, 330 }, { 0, 180, 270 },
    { 0, 90, 180, 270 }, { 0, 60, 180, 240 } };
  for (const std::vector<double>& directions : stars)
  {
    SCOPED_TRACE(directions[1]);
    const Skeleton skeleton =
      skeletonOf(turned(unionOf(star(directions, 1.5, 0.2), 0.05), 2, 0.3), 96);
    ASSERT_EQ(skeleton.branches.size(), directions.size());
    ASSERT_EQ(skeleton.junctions(), 1);
    std::vector<double> found;
    for (const SkeletonBranch& branch : skeleton.branches)
    {
      const Point3& junction = skeleton.points[branch.points.front()];
      EXPECT_LT(distance(junction, Point3{}), 0.2 * 0.2);
      const Point3 along = minus(skeleton.points[branch.points.back()], junction);
      found.push_back(
        std::fmod(degrees(std::atan2(along[1], along[0]) - 0.3) + 721.0, 360.0) - 1.0);
    }
    std::sort(found.begin(), found.end());
    for (std::size_t i = 0; i < found.size(); ++i)
    {
      EXPECT_NEAR(found[i], directions[i], 2.0);
    }
  }
}

TEST(Skeleton, OpensLoopsThatOnlyVoxelsClose)
{
  // Between two of these tubes the gap is so narrow that voxels touch across it.
  const TriangleMesh mesh = turned(unionOf(star({ 0, 60, 180, 240 }, 1.5, 0.2), 0.05), 2, 0.3);
  const MedialAxis axis = axisOf(mesh, 96);
  ASSERT_GT(axis.solid->genus, 0);
  EXPECT_EQ(topologyOf(computeSkeleton(axis, mesh)).genus, 0);
}

TEST(Skeleton, KeepsStubsThatRiseByMoreThanTheirRadius)
{
  const auto withStub = [](double rise)
  {
    return unionOf({ { { -1.5, 0.0, 0.0 }, { 1.5, 0.0, 0.0 }, 0.3 },
                     { { 0.1, 0.0, 0.0 }, { 0.1, 0.3 + rise - 0.12, 0.0 }, 0.12 } },
      0.05);
  };
  EXPECT_EQ(skeletonOf(withStub(0.3), 160).branches.size(), 3u);
  EXPECT_EQ(skeletonOf(withStub(0.05), 160).branches.size(), 1u);
}

TEST(Skeleton, RidgesAndBumpsHaveNoBranches)
{
  // Balls of the tube cover most of them, however far from its middle their sheets lead.
  const auto ring = [](const std::function<double(double, double)>& radius)
  {
    constexpr int kAround = 160;
    constexpr int kAcross = 64;
    TriangleMesh mesh = torus(1.0, 0.3, kAround, kAcross);
    for (Point3& point : mesh.points)
    {
      const double around = std::atan2(point[1], point[0]);
      const double out = std::hypot(point[0], point[1]) - 1.0;
      const double across = std::atan2(point[2], out);
      const double r = radius(around, across);
      const double x = 1.0 + r * std::cos(across);
      point = { x * std::cos(around), x * std::sin(around), r * std::sin(across) };
    }
    return mesh;
  };
  const auto ridges = [](double x) { return std::pow(std::abs(std::cos(x)), 8.0); };
  for (const TriangleMesh& mesh :
    { ring([&](double s, double t) { return 0.25 + 0.07 * ridges(3.0 * t + 3.0 * s); }),
      ring([&](double s, double t)
        { return 0.25 + 0.05 * std::max(ridges(2.5 * t + 4.0 * s), ridges(2.5 * t - 4.0 * s)); }),
      ring(
        [](double s, double t) { return 0.3 + 0.04 * std::sin(5.0 * t) * std::sin(17.0 * s); }) })
  {
    for (const double angle : { 45.0, 60.0, 75.0, 90.0 })
    {
      SCOPED_TRACE(angle);
      const Skeleton skeleton = computeSkeleton(axisOf(mesh, 96, angle), mesh);
      ASSERT_EQ(skeleton.branches.size(), 1u);
      EXPECT_EQ(skeleton.branches.front().kind, BranchKind::Closed);
      EXPECT_NEAR(skeleton.branches.front().length, 2.0 * kPi, 0.05 * 2.0 * kPi);
    }
  }
}

TEST(Skeleton, PrunesShortBranchesButNoLoops)
{
  const TriangleMesh mesh = unionOf(
    { { { -1.5, 0.0, 0.0 }, { 1.5, 0.0, 0.0 }, 0.2 }, { {}, { 0.0, 0.8, 0.0 }, 0.2 } }, 0.05);
  EXPECT_EQ(skeletonOf(mesh, 96, 3.0).branches.size(), 3u);
  EXPECT_EQ(skeletonOf(mesh, 96, 5.0).branches.size(), 1u); // 0.8 / 0.2 is less
  const Skeleton ring = skeletonOf(torus(1.0, 0.3, 64, 32), 64, 1000.0);
  ASSERT_EQ(ring.branches.size(), 1u);
  EXPECT_EQ(ring.branches.front().kind, BranchKind::Closed);
}

class SkeletonOfModel : public testing::TestWithParam<std::filesystem::path>
{
};

/// Longest way along a line between two points in the ball around one of them, over their distance.
double longestDetour(const Skeleton& skeleton, const SkeletonBranch& branch)
{
  constexpr double kFar = 4.0; // in radii, from where on it is a loop
  double longest = 1.0;
  for (std::size_t i = 0; i < branch.points.size(); ++i)
  {
    const std::int64_t a = branch.points[i];
    double way = 0.0;
    for (std::size_t j = i + 1; j < branch.points.size(); ++j)
    {
      const std::int64_t b = branch.points[j];
      way += distance(skeleton.points[branch.points[j - 1]], skeleton.points[b]);
      const double chord = distance(skeleton.points[a], skeleton.points[b]);
      if (chord < std::max(skeleton.radius[a], skeleton.radius[b]) &&
        way < kFar * skeleton.radius[a])
      {
        longest = std::max(longest, way / chord);
      }
    }
  }
  return longest;
}

class SkeletonOfBlock : public SkeletonOfModel
{
};

// The axis of this figure's pedestal leads curves around its rims.
TEST_P(SkeletonOfBlock, CurvesDoNotTurnBackWithinABall)
{
  const TriangleMesh mesh = loadMesh(GetParam());
  for (const int resolution : { 128, 192, 256 })
  {
    SCOPED_TRACE(resolution);
    const Skeleton skeleton = skeletonOf(mesh, resolution);
    for (const SkeletonBranch& branch : skeleton.branches)
    {
      EXPECT_LT(longestDetour(skeleton, branch), 2.5);
    }
  }
}

// A thinned axis of this tube with ridges leaves the solid for some voxels, and comes back; and its
// ridges have sheets of their own, along which curves run to the surface.
TEST_P(SkeletonOfModel, AKnotIsALoopWithoutBranches)
{
  const TriangleMesh mesh = loadMesh(GetParam());
  double length = kUnknown; // whatever resolution and angle are
  for (const auto& [resolution, angle] :
    { std::pair(96, 60.0), std::pair(128, 60.0), std::pair(256, 60.0), std::pair(256, 90.0) })
  {
    SCOPED_TRACE(std::to_string(resolution) + " " + std::to_string(angle));
    const Skeleton skeleton = computeSkeleton(axisOf(mesh, resolution, angle), mesh);
    EXPECT_EQ(skeleton.branches.size(), 2u);
    ASSERT_EQ(skeleton.count(BranchKind::Closed), 2);
    for (const SkeletonBranch& branch : skeleton.branches)
    {
      length = std::isnan(length) ? branch.length : length;
      EXPECT_NEAR(branch.length, length, 0.01 * length);
    }
  }
}

/// If it is there.
std::vector<std::filesystem::path> model(const std::string& name)
{
  const auto path = modelPath(name);
  return path ? std::vector<std::filesystem::path>{ *path } : std::vector<std::filesystem::path>();
}

GTEST_ALLOW_UNINSTANTIATED_PARAMETERIZED_TEST(SkeletonOfModel);
INSTANTIATE_TEST_SUITE_P(Knot, SkeletonOfModel,
  testing::ValuesIn(model("multi/knot2_2comp_11.5k.off")));
GTEST_ALLOW_UNINSTANTIATED_PARAMETERIZED_TEST(SkeletonOfBlock);
INSTANTIATE_TEST_SUITE_P(Gargoyle, SkeletonOfBlock,
  testing::ValuesIn(model("paper/derived/gargoyle_11000.off")));

TEST(Skeleton, TakesNoDetours)
{
  // The arms of this axis are joined through a curve to the surface and back.
  const TriangleMesh mesh =
    turned(turned(turned(askew(unionOf(star({ 0, 180, 270 }, 1.5, 0.2), 0.05)), 0, 0.74), 1, 2.26),
      2, 1.42);
  const Skeleton skeleton = skeletonOf(mesh, 128);
  ASSERT_EQ(skeleton.branches.size(), 3u);
  for (const SkeletonBranch& branch : skeleton.branches)
  {
    EXPECT_NEAR(branch.length, 1.5, 0.015);
    EXPECT_GT(branch.minRadius, 0.19);
  }
}
