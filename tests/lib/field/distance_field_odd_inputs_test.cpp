#include "medial/distance_field.h"

#include "support/field_checks.h"
#include "support/medial_truth.h"
#include "support/named.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <string>
#include <vector>

using namespace medial;
using namespace medial::test;

namespace
{

Grid gridAround(const TriangleMesh& mesh, int resolution = 32)
{
  return makeGrid(mesh.bounds(), resolution, 0.2);
}

Grid gridOf(const Point3& origin, const Point3& spacing, const std::array<int, 3>& dimensions)
{
  return { origin, spacing, dimensions };
}

MeshOnGrid around(const TriangleMesh& mesh)
{
  return { mesh, gridAround(mesh) };
}

/// Faces around the edge from the origin to (0, 0, 1).
TriangleMesh fan(int faces)
{
  std::vector<Point3> points{ { 0.0, 0.0, 0.0 }, { 0.0, 0.0, 1.0 } };
  std::vector<std::array<int, 3>> triangles;
  for (int i = 0; i < faces; ++i)
  {
    const double angle = 1.0 + 1.1 * i;
    points.push_back({ std::cos(angle), std::sin(angle), 0.3 + 0.1 * i });
    triangles.push_back({ 0, 1, i + 2 });
  }
  return makeMesh(points, triangles);
}

/// Two tetrahedra that share a corner at the origin.
TriangleMesh bowTie()
{
  const TriangleMesh one = regularTetrahedron(1.0);
  const Point3& corner = one.points[0];
  const TriangleMesh up = translated(one, { -corner[0], -corner[1], -corner[2] });
  return appended(up, rotated90(rotated90(up, 0), 0));
}

TriangleMesh duplicates()
{
  const TriangleMesh mesh = torus(1.0, 0.3, 16, 8);
  return buildTriangleMesh(unwelded(appended(mesh, flipOrientation(mesh))));
}

/// Triangles without area: collinear corners in any order, two equal corners, three equal corners.
TriangleMesh zeroAreaTriangles()
{
  return makeMesh({ { 0.0, 0.0, 0.0 }, { 1.0, 0.0, 0.0 }, { 0.3, 0.0, 0.0 }, { 0.0, 1.0, 0.2 },
                    { 0.1, 0.2, 0.3 }, { 0.3, 0.6, 0.9 }, { 0.2, 0.4, 0.6 } },
    { { 0, 1, 2 }, { 0, 1, 3 }, { 4, 5, 6 }, { 3, 3, 5 }, { 6, 6, 6 }, { 1, 0, 2 } });
}

/// Needles and caps of decreasing height over edges of length 1, tilted.
TriangleMesh needles()
{
  std::vector<Point3> points;
  std::vector<std::array<int, 3>> triangles;
  double y = 0.0;
  for (const double height : { 1e-1, 1e-2, 1e-3, 1e-5, 1e-8, 1e-12 })
  {
    for (const double foot : { 0.0, 0.5, 0.99, 1.0, 1.4 })
    {
      const int first = static_cast<int>(points.size());
      points.insert(points.end(),
        { { 0.0, y, 0.0 }, { 1.0, y, 0.0 }, { foot, y + height, 0.5 * height } });
      triangles.push_back({ first, first + 1, first + 2 });
      y += 0.21;
    }
  }
  return tilted(makeMesh(points, triangles));
}

/// Two triangles without area on the same points, each with two longest edges.
TriangleMesh tiedSlivers()
{
  return makeMesh({ { 0.0, 0.0, 0.0 }, { 0.0, 1e-13, 0.0 }, { 1.0, 0.0, 0.0 } },
    { { 0, 1, 2 }, { 2, 0, 1 } });
}

/// Two nearly parallel sheets of long strips, whose edges between coplanar triangles have regions
/// of hardly any width. They diverge, and seen from z = 0 one is `excess` farther away than the
/// other.
TriangleMesh longStrips(double length, double width, int count, double excess)
{
  std::vector<Point3> points;
  std::vector<std::array<int, 3>> triangles;
  for (const double z : { -1.0, 1.0 + excess })
  {
    for (int i = 0; i <= count; ++i)
    {
      const int n = static_cast<int>(points.size());
      points.push_back({ 0.0, i * width, z });
      points.push_back({ length, i * width + 0.3 * length, 6.0 * z });
      if (i > 0)
      {
        triangles.push_back({ n - 2, n - 1, n });
        triangles.push_back({ n - 1, n + 1, n });
      }
    }
  }
  return makeMesh(points, triangles);
}

/// A triangle given twice and two neighbours, from a chair with double faces: the polygons of their
/// common edge have nearly collinear corners.
TriangleMesh doubledTriangle()
{
  return makeMesh({ { 0.215344, -0.0233522, -0.00842154 }, { 0.2361, -0.0249683, -0.00990934 },
                    { 0.206755, -0.0182587, -0.0633449 }, { 0.214676, -0.0182587, 0.047165 },
                    { 0.193932, -0.0180299, 0.04418 } },
    { { 0, 1, 2 }, { 1, 3, 0 }, { 0, 3, 1 }, { 3, 0, 4 } });
}

TriangleMesh strayCells()
{
  return makeMesh({ { 0.0, 0.0, 0.0 }, { 1.0, 0.2, 0.0 }, { 0.4, 0.9, 0.1 }, { 0.0, 0.5, 0.8 },
                    { 1.0, 0.5, 0.7 }, { 0.5, 0.1, 1.0 } },
    { { 0, 1, 2 } }, { { 3, 4 }, { 0, 1 } }, { 5, 2 });
}

std::vector<Named<MeshOnGrid>> oddMeshes()
{
  return { { "soup", [] { return around(randomSoup(60, 11)); } },
    { "openMesh", [] { return around(plates(0.4, 1.0)); } },
    { "edgeWithThreeFaces", [] { return around(fan(3)); } },
    { "edgeWithFiveFaces", [] { return around(fan(5)); } },
    { "bowTie", [] { return around(bowTie()); } },
    { "duplicates", [] { return around(duplicates()); } },
    { "zeroAreaTriangles", [] { return around(zeroAreaTriangles()); } },
    { "needles", [] { return around(needles()); } },
    { "tiedSlivers", [] { return around(tiedSlivers()); } },
    { "hair",
      [] {
        return around(appended(hair(0.5, 6), translated(plates(0.1, 0.3), { 0.0, 0.5, 0.2 })));
      } },
    { "trianglesSegmentsPoints", [] { return around(strayCells()); } },
    { "triangle",
      []
      {
        return around(
          makeMesh({ { 0.0, 0.0, 0.0 }, { 1.0, 0.1, 0.2 }, { 0.3, 0.8, 0.4 } }, { { 0, 1, 2 } }));
      } },
    { "segment",
      [] {
        return around(makeMesh({ { 0.0, 0.0, 0.0 }, { 1.0, 0.3, 0.2 } }, {}, { { 0, 1 } }));
      } },
    { "point",
      [] {
        return around(makeMesh({ { 0.3, -0.2, 5.0 } }, {}, {}, { 0 }));
      } },
    { "farAway",
      [] {
        return around(translated(torus(0.5, 0.2, 24, 12), { 1e6, -1e6, 1e6 }));
      } },
    { "tiny", [] { return around(scaled(torus(0.5, 0.2, 24, 12), 1e-6)); } },
    { "huge", [] { return around(scaled(torus(0.5, 0.2, 24, 12), 1e6)); } },
    { "subVoxelTriangles", [] { return around(scaled(icosphere(1.0, 5), 0.3)); } } };
}

std::vector<Named<MeshOnGrid>> oddGrids()
{
  static const Point3 h{ 0.05, 0.05, 0.05 };
  const auto ring = [](const Grid& grid) { return MeshOnGrid{ torus(1.0, 0.4, 32, 16), grid }; };
  return { { "oneThickInX",
             [=] {
               return ring(gridOf({ 0.83, -1.5, -0.6 }, h, { 1, 61, 25 }));
             } },
    { "oneThickInY",
      [=] {
        return ring(gridOf({ -1.5, 0.21, -0.6 }, h, { 61, 1, 25 }));
      } },
    { "oneThickInZ",
      [=] {
        return ring(gridOf({ -1.5, -1.5, 0.13 }, h, { 61, 61, 1 }));
      } },
    { "row",
      [=] {
        return ring(gridOf({ -1.5, 0.11, 0.13 }, h, { 61, 1, 1 }));
      } },
    { "column",
      [=] {
        return ring(gridOf({ 0.33, 0.11, -0.7 }, h, { 1, 1, 61 }));
      } },
    { "onePoint",
      [=] {
        return ring(gridOf({ 0.91, 0.17, 0.11 }, h, { 1, 1, 1 }));
      } },
    { "flatVoxels",
      [=] {
        return ring(gridOf({ -1.5, -1.5, -0.6 }, { 0.1, 0.1, 0.01 }, { 31, 31, 121 }));
      } },
    { "unequalSpacing",
      [=] {
        return ring(gridOf({ -1.5, -1.5, -0.6 }, { 0.03, 0.07, 0.19 }, { 101, 43, 7 }));
      } },
    { "wideVoxels",
      [=] {
        return ring(gridOf({ -1.5, -1.5, -0.6 }, { 0.5, 0.02, 0.06 }, { 7, 151, 21 }));
      } },
    { "outside",
      [=] {
        return ring(gridOf({ 3.0, 2.0, 5.0 }, h, { 30, 25, 20 }));
      } },
    { "farOutside",
      [=] {
        return ring(gridOf({ 60.0, -40.0, 50.0 }, h, { 30, 25, 20 }));
      } },
    { "inside",
      [] {
        return MeshOnGrid{ box({ 3.0, 2.0, 2.5 }),
          gridOf({ -0.7, -0.4, -0.5 }, h, { 30, 25, 20 }) };
      } },
    { "insideLargeMesh",
      []
      {
        return MeshOnGrid{ scaled(icosphere(1.0, 4), 50.0),
          gridOf({ -0.7, -0.4, -0.5 }, h, { 30, 25, 20 }) };
      } },
    { "onLargeMesh",
      []
      {
        return MeshOnGrid{ scaled(icosphere(1.0, 4), 50.0),
          gridOf({ 30.0, 40.0, -0.5 }, h, { 30, 25, 20 }) };
      } },
    { "onVeryLargeMesh",
      []
      {
        return MeshOnGrid{ scaled(tilted(icosphere(1.0, 2)), 5e3),
          gridOf({ 2500.0, 3000.0, 2800.0 }, h, { 30, 25, 20 }) };
      } },
    { "doubledTriangle",
      []
      {
        return MeshOnGrid{ doubledTriangle(),
          gridOf({ -0.321262419, -0.381877969, -0.0121231101 },
            { 0.0121231101, 0.0121231101, 0.0121231101 }, { 54, 64, 1 }) };
      } } };
}

class OddMesh : public testing::TestWithParam<Named<MeshOnGrid>>
{
};

class LongStrips : public testing::TestWithParam<double>
{
};

} // namespace

TEST_P(OddMesh, IsExactAtEveryVoxel)
{
  const auto [mesh, grid] = GetParam().make();
  expectExactField(mesh, grid);
}

INSTANTIATE_TEST_SUITE_P(Meshes, OddMesh, testing::ValuesIn(oddMeshes()), kNameOfParameter);
INSTANTIATE_TEST_SUITE_P(Grids, OddMesh, testing::ValuesIn(oddGrids()), kNameOfParameter);

/// On the middle slice polygons of a thousand by a hundredth of a voxel compete at distances that
/// differ by a fraction of a voxel.
TEST_P(LongStrips, AreExactBetweenTheSheets)
{
  const double h = 0.02;
  const TriangleMesh mesh = longStrips(20.0, GetParam(), 6, 0.1 * h);
  const Grid grid = gridOf({ 0.0, 0.0, 0.0 }, { h, h, h }, { 1000, 250, 1 });
  expectExactField(mesh, grid);
}

INSTANTIATE_TEST_SUITE_P(Width, LongStrips, testing::Values(0.0002, 0.01, 0.7));
