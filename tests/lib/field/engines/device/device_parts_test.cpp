// What is larger than a storage buffer may be.
#include "device_runs.h"
#include "field/engines/device/device_mesh.h"
#include "field/engines/device/mesh_parts.h"
#include "field/engines/fallback_engine.h"
#include "field/engines/processor/processor_engine.h"
#include "gl/fault.h"
#include "medial/compute_distance_field.h"
#include "medial/error.h"
#include "medial/medial_solver.h"

#include "support/errors.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

namespace medial::test
{
namespace
{

/// Lowers the limit of storage buffers.
struct StorageLimit
{
  explicit StorageLimit(std::int64_t bytes) { gl::limitStorageBuffers(bytes); }
  ~StorageLimit() { gl::limitStorageBuffers(0); }
  StorageLimit(const StorageLimit&) = delete;
  StorageLimit& operator=(const StorageLimit&) = delete;
};

constexpr std::int64_t kMiB = 1 << 20;

/// Triangles, segments and points, more than fit the limit below.
TriangleMesh largeMixture()
{
  TriangleMesh mesh = appended(randomSoup(4000, 5),
    makeMesh({ { 0.1, 0.2, 0.9 }, { -0.9, 0.2, 0.9 }, { 0.5, 0.5, 0.5 } }, {}, { { 0, 1 } },
      { 2 }));
  return appended(mesh, torus(1.0, 0.3, 40, 20));
}

TEST(DeviceEngine, SplitsSlicesLargerThanAStorageBuffer)
{
  const Grid wide{ { -1.5, -1.4, -0.3 }, { 0.03, 0.02, 0.06 }, { 100, 141, 5 } };
  const TriangleMesh bar = makeMesh({ { 0.1, 0.2, 0.9 }, { -0.9, 0.2, 0.9 } }, {}, { { 0, 1 } });
  const TriangleMesh mesh = appended(bar, ring());
  ProcessorEngine processor;
  const Computed expected = computedBy(processor, mesh, wide);
  for (const std::int64_t limit : { kMiB / 6, kMiB / 11 }) // bands of 109 and of 59 rows
  {
    SCOPED_TRACE(limit);
    const StorageLimit lower(limit);
    DeviceEngine engine;
    const Computed split = computedBy(engine, mesh, wide, true);
    EXPECT_EQ(split.field.statistics.engine, Engine::Device);
    const FieldDifference found = difference(mesh, split.field, expected.field);
    EXPECT_LE(found.distance, 1e-4);
    EXPECT_EQ(found.untiedSites, 0u);
    EXPECT_NEAR(static_cast<double>(split.crossings.size()),
      static_cast<double>(expected.crossings.size()),
      0.005 * static_cast<double>(expected.crossings.size()));
    // The same after a grid with smaller slices.
    EXPECT_GT(computedBy(engine, mesh, tallGrid()).field.statistics.dispatches, 0);
    const Computed again = computedBy(engine, mesh, wide);
    EXPECT_EQ(again.field.distance, split.field.distance);
    EXPECT_EQ(again.field.closestSite, split.field.closestSite);
  }
  DeviceEngine whole;
  const Computed unlimited = computedBy(whole, mesh, wide);
  EXPECT_LE(difference(mesh, unlimited.field, expected.field).distance, 1e-4);
}

TEST(DeviceEngine, RefusesRowsLargerThanAStorageBuffer)
{
  const StorageLimit limit(kMiB / 16);
  const Grid wide{ { -1.5, -1.5, 0.0 }, { 0.0005, 0.5, 0.5 }, { 5000, 3, 1 } };
  DeviceEngine engine;
  EXPECT_EQ(messageOf([&] { computedBy(engine, ring(), wide); }, ErrorCode::GpuLimit),
    "rows of 5000 grid points exceed the 4096 that fit the driver's limit for buffers");
}

TEST(DeviceEngine, SplitsMeshesLargerThanAStorageBuffer)
{
  struct Case
  {
    const char* name;
    TriangleMesh mesh;
    std::int64_t limit;
    int resolution;
  };
  const Case cases[] = { { "sphere", icosphere(1.0, 6), kMiB, 14 },
    { "ring", torus(1.0, 0.35, 80, 40), kMiB / 4, 40 },
    { "mixture", largeMixture(), kMiB / 4, 24 } };
  for (const Case& one : cases)
  {
    SCOPED_TRACE(one.name);
    const Grid grid = makeGrid(one.mesh.bounds(), one.resolution, 0.2);
    ProcessorEngine processor;
    const Computed expected = computedBy(processor, one.mesh, grid);
    const StorageLimit limit(one.limit);
    ASSERT_GT(DeviceMesh::largestBuffer(one.mesh, analyseConnectivity(one.mesh)), one.limit);
    DeviceEngine engine;
    const Computed split = computedBy(engine, one.mesh, grid, true);
    EXPECT_EQ(split.field.statistics.engine, Engine::Device);
    EXPECT_GT(split.field.statistics.dispatches, 0);
    const FieldDifference found = difference(one.mesh, split.field, expected.field);
    EXPECT_LE(found.distance, 1e-4);
    EXPECT_EQ(found.untiedSites, 0u);
    EXPECT_NEAR(static_cast<double>(split.crossings.size()),
      static_cast<double>(expected.crossings.size()),
      0.002 * static_cast<double>(expected.crossings.size()));
    // The same bytes in the next frame, which moves positions only.
    const Computed again = computedBy(engine, one.mesh, grid);
    EXPECT_EQ(again.field.distance, split.field.distance);
    EXPECT_EQ(again.field.closestSite, split.field.closestSite);
    EXPECT_LT(again.field.statistics.bytesUploaded, split.field.statistics.bytesUploaded / 2);
  }
}

TEST(SplitField, LeadsToTheProcessorWhereTheDeviceIsReset)
{
  const TriangleMesh mesh = torus(1.0, 0.35, 80, 40);
  FallbackEngine engine(makeDevice);
  const StorageLimit limit(kMiB / 4);
  gl::injectFault(gl::Fault::ContextLost, 200);
  const Computed computed = computedBy(engine, mesh, tallGrid());
  EXPECT_EQ(computed.field.statistics.engine, Engine::Processor);
  EXPECT_NE(computed.field.statistics.note, "");
  const Computed again = computedBy(engine, mesh, tallGrid());
  EXPECT_EQ(again.field.statistics.engine, Engine::Device);
  const FieldDifference found = difference(mesh, computed.field, again.field);
  EXPECT_LE(found.distance, 1e-4);
  EXPECT_EQ(found.untiedSites, 0u);
}

TEST(DeviceEngine, SplitsMeshesInMotionWithAllArraysAndSigns)
{
  const TriangleMesh mesh = torus(1.0, 0.35, 60, 30);
  const StorageLimit limit(kMiB / 4);
  MedialSolver solver(mesh);
  for (const SignMethod sign : { SignMethod::Winding, SignMethod::Pseudonormal, SignMethod::None })
  {
    DistanceFieldOptions options;
    options.sign = sign;
    options.engine = Engine::Device;
    for (const double factor : { 1.0, 0.8 })
    {
      const TriangleMesh moved = scaled(mesh, factor);
      const Grid grid = makeGrid(moved.bounds(), 24, 0.2);
      expectExact(moved, computeDistanceField(moved, grid, options), allVoxels(grid));
      DistanceField field;
      field.grid = grid;
      field.distance.resize(grid.pointCount());
      field.closestSite.resize(grid.pointCount());
      FieldArrays arrays;
      arrays.distance = field.distance.data();
      arrays.closestSite = field.closestSite.data();
      solver.setPoints(moved.points);
      solver.computeField(grid, grid.wholeExtent(), arrays, options);
      DistanceFieldOptions byProcessor = options;
      byProcessor.engine = Engine::Processor;
      const FieldDifference found =
        difference(moved, field, computeDistanceField(moved, grid, byProcessor));
      EXPECT_LE(found.distance, 1e-4);
      EXPECT_EQ(found.untiedSites, 0u);
    }
  }
}

/// The points of a site.
std::vector<int> cornersOf(std::size_t site, const TriangleMesh& mesh,
  const MeshConnectivity& connectivity)
{
  const std::size_t faces = mesh.triangles.size();
  if (site < faces)
  {
    return { mesh.triangles[site].begin(), mesh.triangles[site].end() };
  }
  if (site - faces < connectivity.edges.size())
  {
    const auto& edge = connectivity.edges[site - faces];
    return { edge.begin(), edge.end() };
  }
  return { static_cast<int>(site - faces - connectivity.edges.size()) };
}

TEST(MeshParts, HaveEveryElementOnceAndTheNamesOfTheWholeMesh)
{
  const TriangleMesh mesh = largeMixture();
  const MeshConnectivity connectivity = analyseConnectivity(mesh);
  const auto firstEdge = static_cast<std::int32_t>(mesh.triangles.size());
  std::vector<int> found(firstEdge + connectivity.edges.size() + mesh.points.size());
  const std::vector<MeshPart> parts = splitMesh(mesh, connectivity, 700);
  EXPECT_GT(parts.size(), 5u);
  for (const MeshPart& part : parts)
  {
    const std::size_t faces = part.mesh.triangles.size();
    const std::size_t edges = part.connectivity.edges.size();
    EXPECT_LE(faces + part.mesh.segments.size() + part.mesh.vertices.size(), 700u);
    ASSERT_EQ(part.sites.size(), faces + edges + part.points.size());
    for (std::size_t i = 0; i < part.sites.size(); ++i)
    {
      const std::int32_t site = part.sites[i];
      ++found[site];
      std::vector<int> corners = cornersOf(i, part.mesh, part.connectivity);
      const std::vector<int> expected = cornersOf(site, mesh, connectivity);
      ASSERT_EQ(corners.size(), expected.size());
      for (int& corner : corners)
      {
        corner = part.points[corner];
      }
      EXPECT_TRUE(std::is_permutation(corners.begin(), corners.end(), expected.begin()));
    }
  }
  for (std::int32_t site = 0; site < static_cast<std::int32_t>(found.size()); ++site)
  {
    EXPECT_GE(found[site], 1) << site;
    EXPECT_TRUE(site >= firstEdge || found[site] == 1) << site;
  }
}

} // namespace
} // namespace medial::test
