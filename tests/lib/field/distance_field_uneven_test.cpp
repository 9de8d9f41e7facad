// Triangles that are far smaller or far larger than a voxel, in all mixtures.
#include "medial/compute_distance_field.h"

#include "support/collecting_sink.h"
#include "support/field_checks.h"
#include "support/named.h"
#include "support/shapes.h"
#include "support/uneven_meshes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

using namespace medial;
using namespace medial::test;

namespace
{

/// Voxels of a field that are checked.
constexpr std::size_t kSamples = 50000;

/// Triangles of a mesh that the rasteriser draws on a processor in little time.
constexpr std::size_t kForEveryEngine = 6000;

/// A grid of spacing 1 that has no point on a plane of symmetry through the origin.
Grid gridFrom(const Point3& origin, const std::array<int, 3>& dimensions)
{
  return { { origin[0] + 0.137, origin[1] + 0.271, origin[2] + 0.419 }, { 1.0, 1.0, 1.0 },
    dimensions };
}

Grid cube(int points)
{
  const double start = -0.5 * points;
  return gridFrom({ start, start, start }, { points, points, points });
}

/// One triangle across the whole cube of half side 30.
TriangleMesh largeTriangle()
{
  return makeMesh({ { -40.0, -35.0, -20.0 }, { 45.0, -30.0, 5.0 }, { 0.0, 50.0, 12.0 } },
    { { 0, 1, 2 } });
}

/// Needles whose sharp ends, between grid points of integer coordinates, point at more of them;
/// their other ends are up to a hundred thousand voxels away.
TriangleMesh needleRays()
{
  const std::array<Point3, 4> directions{ { { 3.0, 1.0, 0.0 }, { 2.0, -1.0, 1.0 },
    { 3.0, 2.0, -1.0 }, { 1.0, 0.0, 0.0 } } };
  std::vector<Point3> points;
  std::vector<std::array<int, 3>> triangles;
  for (int i = 0; i < 48; ++i)
  {
    const Point3& along = directions[i % 4];
    const double width = 2e-4 * std::pow(10.0, i / 12);
    const auto at = [&](double steps)
    {
      return Point3{ 12.0 + steps * along[0], i % 24 + steps * along[1],
        5.0 * (i % 5) + steps * along[2] };
    };
    const Point3 far = at(4.6 * std::pow(10.0, i % 5));
    const int n = 3 * i;
    points.insert(points.end(), { at(0.3), far, { far[0], far[1], far[2] + width } });
    triangles.push_back({ n, n + 1, n + 2 });
  }
  return makeMesh(points, triangles);
}

/// Everything that can go wrong, in one place.
TriangleMesh allSorts()
{
  TriangleMesh mesh = appended(roughSphere(2.3, 4, 0.05), needleFan(40, 25.0));
  mesh = appended(mesh, scatteredTriangles(1500, 1e-3, 1e2, 14.0));
  mesh = appended(mesh, translated(twistedStrip(5, 28.0, 0.01), { -14.0, 3.3, -4.1 }));
  return appended(mesh, scatteredSegmentsAndVertices(12, 14.0));
}

/// Unequal spacing, and several blocks of slices.
Grid flatVoxels()
{
  return { { -13.86, -14.73, -14.58 }, { 1.0, 1.7, 0.31 }, { 29, 18, 95 } };
}

std::vector<Named<MeshOnGrid>> unevenMeshes()
{
  return { { "tenthsOfAVoxel",
             [] {
               return MeshOnGrid{ roughSphere(6.3, 6, 0.01), cube(20) };
             } },
    { "thousandsInsideAVoxel",
      [] {
        return MeshOnGrid{ roughSphere(0.37, 5, 0.2), cube(20) };
      } },
    { "thousandsFarAway",
      [] {
        return MeshOnGrid{ roughSphere(5.3, 5, 0.1), gridFrom({ 90, 60, -80 }, { 20, 20, 20 }) };
      } },
    { "thousandsInTheCornerOfALargeGrid",
      []
      {
        return MeshOnGrid{ translated(roughSphere(1.9, 4, 0.1), { 3.1, 3.2, 3.3 }),
          gridFrom({ 0.0, 0.0, 0.0 }, { 90, 70, 80 }) };
      } },
    { "needlesThroughManyTiles",
      [] {
        return MeshOnGrid{ needleFan(150, 60.0), gridFrom({ -4.0, -15.0, -15.0 }, { 70, 30, 30 }) };
      } },
    { "needlesThatPointAtGridPoints",
      []
      {
        return MeshOnGrid{ needleRays(),
          { { -6.0, -6.0, -6.0 }, { 1.0, 1.0, 1.0 }, { 36, 36, 34 } } };
      } },
    { "twistedStrips",
      []
      {
        const TriangleMesh thin = appended(twistedStrip(6, 60.0, 0.02),
          translated(twistedStrip(2, 60.0, 1e-7), { 0.0, 0.3, 0.1 }));
        return MeshOnGrid{ appended(thin, translated(twistedStrip(30, 60.0, 9.0), { 0, 5.5, 2 })),
          gridFrom({ -4.0, -12.0, -12.0 }, { 70, 24, 24 }) };
      } },
    { "largeTriangleAmongDust",
      []
      {
        return MeshOnGrid{ appended(largeTriangle(), scatteredTriangles(50000, 0.02, 0.1, 20.0)),
          cube(42) };
      } },
    { "fiveOrdersOfMagnitude",
      [] {
        return MeshOnGrid{ scatteredTriangles(3000, 1e-3, 1e2, 15.0), cube(32) };
      } },
    { "allSorts",
      [] {
        return MeshOnGrid{ allSorts(), cube(32) };
      } },
    { "allSortsInFlatVoxels", [] {
       return MeshOnGrid{ allSorts(), flatVoxels() };
     } } };
}

class UnevenMesh : public testing::TestWithParam<Named<MeshOnGrid>>
{
};

DistanceFieldOptions optionsWith(int threads, std::size_t memoryMiB = 0)
{
  DistanceFieldOptions options;
  options.execution.threads = threads;
  options.memoryMiB = memoryMiB;
  return options;
}

void expectSameBytes(const DistanceField& expected, const DistanceField& field)
{
  EXPECT_EQ(expected.distance, field.distance);
  EXPECT_EQ(expected.closestPoint, field.closestPoint);
  EXPECT_EQ(expected.closestSite, field.closestSite);
  EXPECT_EQ(expected.closestFeature, field.closestFeature);
  EXPECT_EQ(expected.closestCell, field.closestCell);
}

/// Expects the same field from slabs of at most so many slices.
void expectSameBytesInSlabs(const DistanceField& expected, const TriangleMesh& mesh, int slices,
  int threads)
{
  const Extent extent = expected.grid.wholeExtent();
  const int slicePoints = extent.size(0) * extent.size(1);
  CollectingSink sink(extent, static_cast<std::size_t>((1 << 20) / slicePoints / slices));
  computeDistanceField(mesh, analyseConnectivity(mesh), expected.grid, extent, sink,
    optionsWith(threads, 1));
  EXPECT_LE(sink.slabs.front().size(2), slices);
  EXPECT_EQ(expected.distance, sink.distance);
  EXPECT_EQ(expected.closestSite, sink.site);
}

} // namespace

TEST_P(UnevenMesh, IsExact)
{
  const auto [mesh, grid] = GetParam().make();
  const Voxels voxels = randomVoxels(grid, kSamples);
  if (mesh.triangles.size() <= kForEveryEngine)
  {
    expectExactField(mesh, grid, voxels);
  }
  else
  {
    expectExact(mesh, computeDistanceField(mesh, grid), voxels);
  }
}

INSTANTIATE_TEST_SUITE_P(Meshes, UnevenMesh, testing::ValuesIn(unevenMeshes()), kNameOfParameter);

TEST(UnevenMeshes, AreNegativeInside)
{
  const DistanceField field = computeDistanceField(roughSphere(6.3, 6, 0.001), cube(20));
  for (std::size_t i = 0; i < field.distance.size(); ++i)
  {
    const Point3 x = voxelPoint(field.grid, i);
    const double fromSphere = std::hypot(x[0], x[1], x[2]) - 6.3;
    if (std::abs(fromSphere) > 0.1)
    {
      ASSERT_EQ(field.distance[i] < 0.0f, fromSphere < 0.0) << i;
    }
  }
}

TEST(UnevenMeshes, HaveTheSameBytesWithAnyThreadsAndMemory)
{
  const TriangleMesh mesh = allSorts();
  const DistanceField expected = computeDistanceField(mesh, flatVoxels(), optionsWith(1));
  expectSameBytes(expected, computeDistanceField(mesh, flatVoxels(), optionsWith(2)));
  expectSameBytes(expected, computeDistanceField(mesh, flatVoxels(), optionsWith(2, 1)));
  expectSameBytesInSlabs(expected, mesh, 1, 1);
  expectSameBytesInSlabs(expected, mesh, 4, 2);
}

TEST(UnevenMeshes, HaveTheSameFieldInParts)
{
  const TriangleMesh mesh = allSorts();
  const DistanceField whole = computeDistanceField(mesh, flatVoxels());
  DistanceField parts = whole;
  std::fill(parts.distance.begin(), parts.distance.end(), 1e6f);
  const MeshConnectivity connectivity = analyseConnectivity(mesh);
  for (const Extent& extent :
    { Extent{ { 0, 0, 0 }, { 28, 17, 30 } }, Extent{ { 0, 0, 31 }, { 10, 17, 94 } },
      Extent{ { 11, 0, 31 }, { 28, 4, 94 } }, Extent{ { 11, 5, 31 }, { 28, 17, 94 } } })
  {
    computePart(mesh, connectivity, extent, parts);
  }
  const FieldDifference found = difference(mesh, whole, parts);
  EXPECT_LE(found.distance, 1e-3);
  EXPECT_EQ(found.untiedSites, 0u);
}

/// Every face is there twice, so both are equally near wherever one is the closest site.
TEST(UnevenMeshes, NameTheFirstOfTwoEqualFaces)
{
  const TriangleMesh mesh = scatteredTriangles(800, 0.01, 20.0, 12.0);
  const TriangleMesh twice = appended(mesh, mesh);
  ASSERT_EQ(twice.triangles.size(), 2 * mesh.triangles.size());
  const DistanceField field = computeDistanceField(twice, cube(26));
  std::size_t first = 0;
  std::size_t second = 0;
  for (const std::int32_t site : field.closestSite)
  {
    const auto id = static_cast<std::size_t>(site);
    first += id < mesh.triangles.size() ? 1 : 0;
    second += id >= mesh.triangles.size() && id < twice.triangles.size() ? 1 : 0;
  }
  EXPECT_GT(first, 1000u);
  EXPECT_EQ(second, 0u);
}
