#include "medial/compute_distance_field.h"

#include "support/field_checks.h"
#include "support/named.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <functional>
#include <string>
#include <utility>
#include <vector>

using namespace medial;
using namespace medial::test;

namespace
{

constexpr int kPoints = 41;

/// Points symmetric about the origin, so that turns and mirrors map them onto each other.
Grid cube(double scale = 1.0)
{
  const double spacing = 0.07 * scale;
  const double start = -0.5 * (kPoints - 1) * spacing;
  return { { start, start, start }, { spacing, spacing, spacing }, { kPoints, kPoints, kPoints } };
}

/// No symmetry, saddles, a hole and flat parts.
TriangleMesh shape()
{
  const TriangleMesh ring = translated(torus(0.8, 0.23, 24, 12), { 0.11, 0.03, -0.21 });
  return appended(ring, translated(box({ 0.21, 0.33, 0.17 }), { 0.07, -0.05, 0.53 }));
}

using Index = std::array<int, 3>;

/// `field` with its voxels moved by `map` and lengths divided by `factor`.
DistanceField movedBack(const DistanceField& field, double factor,
  const std::function<Index(Index)>& map)
{
  DistanceField back = field;
  back.grid = cube();
  for (std::size_t v = 0; v < back.distance.size(); ++v)
  {
    const auto n = static_cast<std::size_t>(kPoints);
    const Index from =
      map({ static_cast<int>(v % n), static_cast<int>(v / n % n), static_cast<int>(v / n / n) });
    const std::size_t source = from[0] + n * (from[1] + n * from[2]);
    back.distance[v] = static_cast<float>(static_cast<double>(field.distance[source]) / factor);
    back.closestSite[v] = field.closestSite[source];
  }
  return back;
}

Index same(Index index)
{
  return index;
}

void expectSameField(const TriangleMesh& mesh, const DistanceField& expected,
  const DistanceField& field)
{
  ASSERT_EQ(expected.distance.size(), field.distance.size());
  const FieldDifference found = difference(mesh, expected, field);
  EXPECT_LE(found.distance, 1e-3);
  EXPECT_EQ(found.untiedSites, 0u);
}

/// Expects `moved` to be the field of shape(), its voxels moved by `map` and lengths by `factor`.
void expectMovedField(const DistanceField& moved, double factor,
  const std::function<Index(Index)>& map)
{
  const DistanceField original = computeDistanceField(shape(), cube());
  expectSameField(shape(), original, movedBack(moved, factor, map));
}

/// As expectMovedField for a mesh whose triangles are wound the other way, which numbers its sites
/// differently.
void expectMovedFieldOfFlipped(const TriangleMesh& mesh, const std::function<Index(Index)>& map)
{
  const DistanceField moved = computeDistanceField(mesh, cube());
  expectExact(mesh, moved, allVoxels(cube()));
  const DistanceField original = computeDistanceField(shape(), cube());
  DistanceField back = movedBack(moved, 1.0, map);
  back.closestSite = original.closestSite;
  expectSameField(shape(), original, back);
}

/// Halves of an extent along an axis.
std::vector<Extent> halves(const Extent& extent, int axis)
{
  Extent low = extent;
  Extent high = extent;
  low.max[axis] = (extent.min[axis] + extent.max[axis]) / 2 + 3;
  high.min[axis] = low.max[axis] + 1;
  return { low, high };
}

class AxisOfGrid : public testing::TestWithParam<int>
{
};

class ScaleOfMesh : public testing::TestWithParam<double>
{
};

class DistanceFieldOptionsOf : public testing::TestWithParam<Named<DistanceFieldOptions>>
{
};

Named<DistanceFieldOptions> optionsWith(int threads, std::size_t memoryMiB)
{
  return { "Threads" + std::to_string(threads) + "MiB" + std::to_string(memoryMiB),
    [=]
    {
      DistanceFieldOptions options;
      options.execution.threads = threads;
      options.memoryMiB = memoryMiB;
      return options;
    } };
}

} // namespace

TEST(DistanceFieldInvariants, MovesWithTheMesh)
{
  const Point3 offset{ 31.25, -17.5, 8.375 };
  Grid grid = cube();
  for (int axis = 0; axis < 3; ++axis)
  {
    grid.origin[axis] += offset[axis];
  }
  expectMovedField(computeDistanceField(translated(shape(), offset), grid), 1.0, same);
}

TEST_P(AxisOfGrid, TurnsWithTheMesh)
{
  const int u = (GetParam() + 1) % 3;
  const int v = (GetParam() + 2) % 3;
  const DistanceField turned = computeDistanceField(rotated90(shape(), GetParam()), cube());
  expectMovedField(turned, 1.0,
    [=](Index index)
    {
      std::swap(index[u], index[v]);
      index[u] = kPoints - 1 - index[u];
      return index;
    });
}

TEST_P(AxisOfGrid, IsMirroredWithTheMesh)
{
  const int axis = GetParam();
  expectMovedFieldOfFlipped(mirrored(shape(), axis),
    [=](Index index)
    {
      index[axis] = kPoints - 1 - index[axis];
      return index;
    });
}

TEST_P(AxisOfGrid, IsTheSameFromTwoHalves)
{
  const TriangleMesh mesh = shape();
  const MeshConnectivity connectivity = analyseConnectivity(mesh);
  const DistanceField whole = computeDistanceField(mesh, cube());
  DistanceField parts = whole;
  std::fill(parts.distance.begin(), parts.distance.end(), 1e6f);
  for (const Extent& extent : halves(whole.grid.wholeExtent(), GetParam()))
  {
    computePart(mesh, connectivity, extent, parts);
  }
  expectSameField(mesh, whole, parts);
}

namespace
{

/// Expects the processor to compute a part of a grid bit for bit as it does within the whole.
void expectSameBits(const DistanceField& whole, const TriangleMesh& mesh, const Extent& extent)
{
  const auto count = static_cast<std::size_t>(extent.pointCount());
  std::vector<float> distance(count);
  std::vector<float> closestPoint(3 * count);
  std::vector<std::int32_t> site(count);
  DistanceFieldOptions options;
  options.engine = Engine::Processor;
  computeDistanceField(mesh, analyseConnectivity(mesh), whole.grid, extent,
    FieldArrays{ distance.data(), closestPoint.data(), site.data() }, options);
  std::size_t differences = 0;
  std::size_t i = 0;
  for (int z = extent.min[2]; z <= extent.max[2]; ++z)
  {
    for (int y = extent.min[1]; y <= extent.max[1]; ++y)
    {
      const std::size_t row =
        (static_cast<std::size_t>(z) * whole.grid.dimensions[1] + y) * whole.grid.dimensions[0];
      for (std::size_t at = row + extent.min[0]; at <= row + extent.max[0]; ++at, ++i)
      {
        const bool same = distance[i] == whole.distance[at] && site[i] == whole.closestSite[at] &&
          std::equal(&closestPoint[3 * i], &closestPoint[3 * i] + 3, &whole.closestPoint[3 * at]);
        differences += same ? 0 : 1;
      }
    }
  }
  EXPECT_EQ(differences, 0u) << "of " << count << " points from " << extent.min[0] << ", "
                             << extent.min[1] << ", " << extent.min[2];
}

/// Extents whose ends are anywhere in tiles.
void expectSameBitsOfParts(const TriangleMesh& mesh, const Grid& grid)
{
  DistanceFieldOptions options;
  options.engine = Engine::Processor;
  const DistanceField whole = computeDistanceField(mesh, grid, options);
  const auto [x, y, z] = grid.wholeExtent().max;
  for (const Extent& extent :
    { Extent{ { 0, 0, 0 }, { 12, y, z } }, Extent{ { 12, 0, 0 }, { x, y, z } },
      Extent{ { 3, 5, 7 }, { 22, 18, z - 1 } }, Extent{ { 8, 8, 8 }, { 15, 15, 15 } },
      Extent{ { x, y, z }, { x, y, z } }, Extent{ { 5, 11, 0 }, { 5, 11, z } } })
  {
    expectSameBits(whole, mesh, extent);
  }
}

} // namespace

TEST(DistanceFieldInvariants, HasTheSameBitsInAnyPartOfTheGrid)
{
  expectSameBitsOfParts(shape(), cube());
}

TEST(DistanceFieldInvariants, HasTheSameBitsInAnyPartFarFromTheMesh)
{
  // Beyond 4096 spacings distances are found in another way, point by point.
  Grid grid = cube();
  grid.origin = { 4075.0 * grid.spacing[0], grid.origin[1], grid.origin[2] };
  expectSameBitsOfParts(shape(), grid);
}

INSTANTIATE_TEST_SUITE_P(Axis, AxisOfGrid, testing::Values(0, 1, 2));

TEST_P(ScaleOfMesh, ScalesTheField)
{
  const double factor = GetParam();
  expectMovedField(computeDistanceField(scaled(shape(), factor), cube(factor)), factor, same);
}

INSTANTIATE_TEST_SUITE_P(Factor, ScaleOfMesh, testing::Values(3.7, 1e-6, 1e6));

TEST(DistanceFieldInvariants, StaysNegativeInsideWhenTheMeshIsTurnedInsideOut)
{
  expectMovedFieldOfFlipped(flipOrientation(shape()), same);
}

TEST(DistanceFieldInvariants, IsTheSameFromSinglePointExtents)
{
  const TriangleMesh mesh = shape();
  const MeshConnectivity connectivity = analyseConnectivity(mesh);
  const DistanceField whole = computeDistanceField(mesh, cube());
  DistanceField parts = whole;
  for (const int i : { 0, 7, 20, 33, 40 })
  {
    computePart(mesh, connectivity, { { i, i, i }, { i, i, i } }, parts);
    computePart(mesh, connectivity, { { 0, i, 3 }, { 40, i, 3 } }, parts);
  }
  expectSameField(mesh, whole, parts);
}

/// On a grid so large that little memory means thin slabs.
TEST_P(DistanceFieldOptionsOf, DoNotMatter)
{
  const TriangleMesh mesh = shape();
  const Grid grid = makeGrid(mesh.bounds(), 200, 0.1);
  const DistanceField expected = computeDistanceField(mesh, grid);
  for (const DistanceFieldOptions& options : enginesFor(grid, GetParam().make()))
  {
    expectSameField(mesh, expected, computeDistanceField(mesh, grid, options));
  }
}

INSTANTIATE_TEST_SUITE_P(ThreadsAndMemory, DistanceFieldOptionsOf,
  testing::Values(optionsWith(1, 0), optionsWith(5, 64), optionsWith(0, 90),
    optionsWith(0, 100000)),
  kNameOfParameter);
