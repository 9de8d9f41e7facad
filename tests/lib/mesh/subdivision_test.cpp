#include "medial/subdivision.h"

#include "medial/error.h"
#include "medial/mesh_connectivity.h"

#include "support/point_math.h"
#include "support/shapes.h"
#include "support/transforms.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <string>
#include <vector>

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

namespace
{

double areaOf(const TriangleMesh& mesh)
{
  double sum = 0.0;
  for (const auto& [cell, area] : areas(mesh))
  {
    sum += area;
  }
  return sum;
}

/// Expects no triangle without area, and no hole where one was.
void expectWithoutFlatTriangles(const TriangleMesh& clean, const TriangleMesh& mesh, double maxEdge,
  const std::string& what)
{
  const TriangleMesh fine = subdivide(mesh, maxEdge).mesh;
  for (const auto& [a, b, c] : fine.triangles)
  {
    ASSERT_TRUE(hasArea(fine.points[a], fine.points[b], fine.points[c])) << what;
  }
  EXPECT_LE(longestEdge(fine), maxEdge) << what;
  const MeshConnectivity before = analyseConnectivity(clean);
  const MeshConnectivity after = analyseConnectivity(fine);
  EXPECT_EQ(after.closed(), before.closed()) << what;
  EXPECT_EQ(after.oriented(), before.oriented()) << what;
  EXPECT_EQ(after.nonManifoldEdges, before.nonManifoldEdges) << what;
  EXPECT_EQ(after.components, before.components) << what;
  EXPECT_NEAR(after.signedVolume, before.signedVolume, 1e-4 * std::abs(before.signedVolume));
  EXPECT_NEAR(areaOf(fine), areaOf(clean), 1e-4 * areaOf(clean)) << what;
}

/// A square in two parts whose common side has points of its own in each.
/// @param points of each part between the ends.
TriangleMesh squareInTwoParts(int points)
{
  std::vector<Point3> places{ { 0, 0, 0 }, { 0, 1, 0 }, { -1, 0.5, 0 }, { 1, 0.5, 0 } };
  std::vector<std::array<int, 3>> triangles;
  int last = 0;
  for (int i = 1; i <= points + 1; ++i)
  {
    const bool end = i > points;
    const int next = end ? 1 : static_cast<int>(places.size());
    if (!end)
    {
      places.push_back({ 0, i / (points + 1.0), 0 });
    }
    triangles.push_back({ last, next, 2 });
    if (!end)
    {
      triangles.push_back({ last, 1, next }); // a fan without area
    }
    last = next;
  }
  triangles.push_back({ 0, 3, 1 });
  return makeMesh(places, triangles);
}

} // namespace

TEST(Subdivision, DividesTrianglesAtCornersOfThoseWithoutAreaOnTheirEdges)
{
  const TriangleMesh plate = box({ 5.0, 3.0, 0.1 });
  const TriangleMesh tilted = translated(turned(turned(plate, 0, 0.7), 2, 1.1), { 70, -30, 9 });
  for (const double height : { 0.0, 1e-14, 1e-12, 1e-10, 1e-8, 1e-6 })
  {
    for (const TriangleMesh& clean : { plate, tilted })
    {
      for (unsigned int seed = 0; seed < 4; ++seed)
      {
        // Triangles that lie on each other add up their heights.
        const int places = height > 1e-9 ? 6 : 60;
        expectWithoutFlatTriangles(clean, withFlatTriangles(clean, places, height, seed), 0.5,
          "height " + std::to_string(height) + ", seed " + std::to_string(seed));
      }
    }
  }
}

TEST(Subdivision, DividesTrianglesAtAFanWithoutArea)
{
  for (const int points : { 1, 2, 7, 300 })
  {
    const TriangleMesh mesh = squareInTwoParts(points);
    const Subdivision fine = subdivide(mesh, 5.0);
    EXPECT_EQ(fine.mesh.triangles.size(), 2U * (static_cast<std::size_t>(points) + 1U));
    EXPECT_TRUE(fine.parents.empty());
    EXPECT_NEAR(areaOf(fine.mesh), 1.0, 1e-9);
    EXPECT_EQ(analyseConnectivity(fine.mesh).boundaryEdges, 4);
  }
}

TEST(Subdivision, DropsTrianglesWithoutAreaOnTheBorder)
{
  const TriangleMesh mesh = makeMesh({ { 0, 0, 0 }, { 1, 0, 0 }, { 0.4, 0, 0 }, { 0, 1, 0 } },
    { { 0, 2, 3 }, { 2, 1, 3 }, { 0, 1, 2 } });
  EXPECT_EQ(subdivide(mesh, 5.0).mesh.triangles,
    (std::vector<std::array<int, 3>>{ { 0, 2, 3 }, { 2, 1, 3 } }));
}

TEST(Subdivision, KeepsAMeshOfNothingButTrianglesWithoutArea)
{
  const TriangleMesh mesh =
    makeMesh({ { 0, 0, 0 }, { 1, 0, 0 }, { 0.4, 0, 0 } }, { { 0, 1, 2 }, { 1, 0, 2 } });
  EXPECT_EQ(subdivide(mesh, 5.0).mesh.triangles, mesh.triangles);
  EXPECT_GT(subdivide(mesh, 0.1).mesh.triangles.size(), 2U);
}

// What lies on each other without area cancels out, or stays without area, but ends.
TEST(Subdivision, EndsForPointsOnOneLine)
{
  std::vector<Point3> points{ { 0, 1, 0 } };
  for (int i = 0; i < 7; ++i)
  {
    points.push_back({ i * i * 0.1, 0, 0 });
  }
  std::vector<std::array<int, 3>> triangles{ { 0, 1, 7 } };
  for (int a = 1; a < 8; ++a)
  {
    for (int b = 1; b < 8; ++b)
    {
      for (int c = 1; c < 8; ++c)
      {
        if (a != b && b != c && c != a && (a + 3 * b + 5 * c) % 4 == 0)
        {
          triangles.push_back({ a, b, c });
        }
      }
    }
  }
  const TriangleMesh fine = subdivide(makeMesh(points, triangles), 10.0).mesh;
  EXPECT_NEAR(areaOf(fine), 1.8, 1e-6);
  EXPECT_LT(fine.triangles.size(), 100000U);
}
