#include "sign/surface_orientation.h"

#include "support/shapes.h"
#include "support/transforms.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <set>
#include <utility>

using namespace medial;
using namespace medial::test;

namespace
{

SurfaceOrientation oriented(const TriangleMesh& mesh)
{
  return orientSurface(mesh, analyseConnectivity(mesh));
}

/// Volume that the triangles enclose as they count.
double volumeOf(TriangleMesh mesh)
{
  const SurfaceOrientation orientation = oriented(mesh);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
  {
    if (orientation.weights[t] < 0)
    {
      std::swap(mesh.triangles[t][0], mesh.triangles[t][1]);
    }
  }
  return signedVolume(mesh);
}

} // namespace

TEST(SurfaceOrientation, LeavesSolidsThatFaceOutwardsAsTheyAre)
{
  const SurfaceOrientation orientation = oriented(torus(1.0, 0.3, 12, 8));
  EXPECT_EQ(orientation.turned, 0);
  EXPECT_EQ(orientation.copies, 0);
  EXPECT_TRUE(orientation.rim.empty());
  EXPECT_TRUE(std::all_of(orientation.weights.begin(), orientation.weights.end(),
    [](int weight) { return weight == 1; }));
}

TEST(SurfaceOrientation, TurnsPartsOutwards)
{
  const TriangleMesh part = box({ 1.0, 1.0, 1.0 });
  const TriangleMesh other = translated(part, { 5.0, 0.0, 0.0 });
  EXPECT_NEAR(volumeOf(appended(part, flipOrientation(other))), 16.0, 1e-12);
  EXPECT_NEAR(volumeOf(flipOrientation(appended(part, other))), 16.0, 1e-12);
}

TEST(SurfaceOrientation, KeepsCavitiesAndWhatIsInThem)
{
  const auto cube = [](double half) { return box({ half, half, half }); };
  const TriangleMesh nested = appended(appended(cube(3.0), flipOrientation(cube(2.0))), cube(1.0));
  const double volume = 216.0 - 64.0 + 8.0;
  EXPECT_NEAR(volumeOf(nested), volume, 1e-9);
  EXPECT_NEAR(volumeOf(flipOrientation(nested)), volume, 1e-9);
}

TEST(SurfaceOrientation, MakesTrianglesAgree)
{
  TriangleMesh mesh = icosphere(1.0, 2);
  const double volume = signedVolume(mesh);
  for (const std::size_t t : { 0, 7, 8, 9, 100 })
  {
    std::swap(mesh.triangles[t][0], mesh.triangles[t][1]);
  }
  EXPECT_EQ(oriented(mesh).turned, 5);
  EXPECT_NEAR(volumeOf(mesh), volume, 1e-12);
}

TEST(SurfaceOrientation, FindsRims)
{
  TriangleMesh mesh = icosphere(1.0, 2);
  mesh.triangles.pop_back();
  mesh.triangleCells.pop_back();
  const SurfaceOrientation orientation = oriented(flipOrientation(mesh));
  EXPECT_EQ(orientation.rim.size(), 3U);
  EXPECT_EQ(orientation.turned, static_cast<std::int64_t>(mesh.triangles.size()));
}

TEST(SurfaceOrientation, LeavesOpenSheetsAsTheyAre)
{
  EXPECT_EQ(oriented(plates(1.0, 1.0)).turned, 0);
}

/// In some positions parts are inside out, one is within another or most of the area runs the other
/// way.
TEST(SurfaceOrienter, FindsInEveryPositionWhatAFreshOneFinds)
{
  TriangleMesh mixed = icosphere(0.8, 1);
  for (std::size_t t = 0; t < mixed.triangles.size(); t += 2)
  {
    std::swap(mixed.triangles[t][0], mixed.triangles[t][1]);
  }
  mixed.triangles.pop_back();
  mixed.triangleCells.pop_back();
  const TriangleMesh mesh =
    appended(appended(box({ 3.0, 3.0, 3.0 }), translated(mixed, { 9.0, 0.0, 0.0 })),
      translated(plates(1.0, 1.0), { 0.0, 9.0, 0.0 }));
  const MeshConnectivity connectivity = analyseConnectivity(mesh);
  SurfaceOrienter orienter;
  std::set<std::int64_t> turned;
  for (int frame = 0; frame < 24; ++frame)
  {
    TriangleMesh moved = mesh;
    for (Point3& point : moved.points)
    {
      const bool inBox =
        std::max({ std::abs(point[0]), std::abs(point[1]), std::abs(point[2]) }) <= 3.0;
      point[0] = inBox ? (frame % 4 == 1 ? -point[0] : point[0]) : point[0] - (frame % 3) * 4.5;
      point[2] *= frame % 5 == 2 ? -1.0 : 1.0;
      // Widens what is at one side.
      point[1] += frame % 2 == 0 ? 0.0 : std::max(0.0, point[0] - 4.5 + frame % 3 * 4.5) * point[1];
    }
    const SurfaceOrientation& found = orienter.orient(moved, connectivity);
    const SurfaceOrientation fresh = orientSurface(moved, connectivity);
    EXPECT_EQ(found.weights, fresh.weights) << frame;
    EXPECT_EQ(found.directions, fresh.directions) << frame;
    EXPECT_EQ(found.copies, fresh.copies);
    EXPECT_EQ(found.turned, fresh.turned);
    ASSERT_EQ(found.rim.size(), fresh.rim.size());
    for (std::size_t i = 0; i < found.rim.size(); ++i)
    {
      EXPECT_EQ(found.rim[i].from, fresh.rim[i].from);
      EXPECT_EQ(found.rim[i].to, fresh.rim[i].to);
      EXPECT_EQ(found.rim[i].weight, fresh.rim[i].weight);
    }
    turned.insert(found.turned);
  }
  EXPECT_GE(turned.size(), 3u);
}
