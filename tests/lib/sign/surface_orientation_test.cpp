#include "sign/surface_orientation.h"

#include "support/shapes.h"
#include "support/transforms.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
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
