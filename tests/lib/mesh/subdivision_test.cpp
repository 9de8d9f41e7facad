#include "medial/subdivision.h"

#include "medial/error.h"
#include "medial/mesh_connectivity.h"

#include "support/point_math.h"
#include "support/shapes.h"
#include "support/transforms.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

using namespace medial;
using namespace medial::test;

namespace
{

double longestEdge(const TriangleMesh& mesh)
{
  double longest = 0.0;
  for (const auto& corners : mesh.triangles)
  {
    for (int side = 0; side < 3; ++side)
    {
      longest = std::max(longest,
        distance(mesh.points[corners[side]], mesh.points[corners[(side + 1) % 3]]));
    }
  }
  return longest;
}

/// Area of the triangles of every cell.
std::map<std::int64_t, double> areas(const TriangleMesh& mesh)
{
  std::map<std::int64_t, double> areas;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
  {
    const auto& corners = mesh.triangles[i];
    const double a = distance(mesh.points[corners[0]], mesh.points[corners[1]]);
    const double b = distance(mesh.points[corners[1]], mesh.points[corners[2]]);
    const double c = distance(mesh.points[corners[2]], mesh.points[corners[0]]);
    const double s = 0.5 * (a + b + c);
    areas[mesh.triangleCells[i]] += std::sqrt(std::max(0.0, s * (s - a) * (s - b) * (s - c)));
  }
  return areas;
}

void expectSameShape(const TriangleMesh& mesh, double maxEdge)
{
  const Subdivision fine = subdivide(mesh, maxEdge);
  EXPECT_LE(longestEdge(fine.mesh), maxEdge);
  const MeshConnectivity before = analyseConnectivity(mesh);
  const MeshConnectivity after = analyseConnectivity(fine.mesh);
  EXPECT_EQ(after.closed(), before.closed());
  EXPECT_EQ(after.oriented(), before.oriented());
  EXPECT_EQ(after.components, before.components);
  EXPECT_NEAR(after.signedVolume, before.signedVolume, 1e-12 * std::abs(before.signedVolume));
  const auto expected = areas(mesh);
  const auto found = areas(fine.mesh);
  ASSERT_EQ(found.size(), expected.size());
  for (const auto& [cell, area] : expected)
  {
    EXPECT_NEAR(found.at(cell), area, 1e-6 * area);
  }
  EXPECT_EQ(fine.originalPoints(), mesh.points.size());
  for (std::size_t i = 0; i < fine.parents.size(); ++i)
  {
    const auto [a, b] = fine.parents[i];
    const auto point = static_cast<int>(mesh.points.size() + i);
    ASSERT_LT(std::max(a, b), point);
    EXPECT_NEAR(distance(fine.mesh.points[point], fine.mesh.points[a]),
      distance(fine.mesh.points[point], fine.mesh.points[b]), 1e-12);
  }
}

} // namespace

TEST(Subdivision, KeepsShapeAndCellsAndHasNoLongEdge)
{
  expectSameShape(box({ 2.0, 1.0, 0.5 }), 0.3);
  expectSameShape(wedge(10.0, 4.0, 1.0), 0.2);
  expectSameShape(icosphere(1.0, 1), 0.25);
  expectSameShape(lPrism(1.0, 3.0), 0.4);
  // A needle beside short edges: triangles with one and two long edges.
  expectSameShape(makeMesh({ { 0, 0, 0 }, { 10, 0, 0 }, { 5, 0.1, 0 }, { 0, -0.2, 0 } },
                    { { 0, 1, 2 }, { 1, 0, 3 } }),
    0.5);
}

TEST(Subdivision, LeavesShortEdgesAlone)
{
  const TriangleMesh mesh = icosphere(1.0, 2);
  const Subdivision same = subdivide(mesh, 2.0);
  EXPECT_EQ(same.mesh.triangles, mesh.triangles);
  EXPECT_EQ(same.mesh.points, mesh.points);
  EXPECT_TRUE(same.parents.empty());
}

TEST(Subdivision, KeepsSegmentsAndVertices)
{
  const TriangleMesh mesh = makeMesh({ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 5, 0, 0 } },
    { { 0, 1, 2 } }, { { 1, 3 } }, { 3 });
  const Subdivision fine = subdivide(mesh, 0.2);
  EXPECT_EQ(fine.mesh.segments, mesh.segments);
  EXPECT_EQ(fine.mesh.vertices, mesh.vertices);
  EXPECT_GT(fine.mesh.triangles.size(), 20U);
}

TEST(Subdivision, RefusesWhatIsOutsideItsRange)
{
  const TriangleMesh mesh = box({ 1.0, 1.0, 1.0 });
  for (const double length : { 0.0, -1.0, std::nan(""), static_cast<double>(HUGE_VAL), 1e-9 })
  {
    EXPECT_THROW(subdivide(mesh, length), Error) << length;
  }
}
