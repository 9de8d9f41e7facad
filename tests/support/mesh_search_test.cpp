// The quick oracle finds what the slow one finds.
#include "support/mesh_search.h"

#include "support/shapes.h"

#include <gtest/gtest.h>

using namespace medial;
using namespace medial::test;

namespace
{

/// Random places in and around the mesh, its corners and the middles of its sides, where many
/// triangles are equally close.
std::vector<Point3> places(const TriangleMesh& mesh)
{
  Bounds around = mesh.bounds();
  const double margin = 0.5 * around.diagonal();
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    around.min[axis] -= margin;
    around.max[axis] += margin;
  }
  std::vector<Point3> points = randomPoints(around, 300, 5);
  for (std::size_t t = 0; t < mesh.triangles.size(); t += 1 + mesh.triangles.size() / 100)
  {
    const Point3& a = mesh.points[mesh.triangles[t][0]];
    const Point3& b = mesh.points[mesh.triangles[t][1]];
    points.push_back(a);
    points.push_back({ 0.5 * (a[0] + b[0]), 0.5 * (a[1] + b[1]), 0.5 * (a[2] + b[2]) });
  }
  return points;
}

void expectTheSame(const TriangleMesh& mesh, const std::vector<Point3>& queries)
{
  const MeshSearch search(mesh);
  for (const Point3& query : queries)
  {
    const Hit expected = closestOnMesh(mesh, query);
    const Hit found = search.closest(query);
    ASSERT_EQ(found.distance, expected.distance);
    ASSERT_EQ(found.kind, expected.kind);
  }
}

} // namespace

TEST(MeshSearch, FindsWhatAllTrianglesGive)
{
  for (const TriangleMesh& mesh :
    { regularTetrahedron(1.0), torus(1.0, 0.3, 40, 20), randomSoup(300, 3), plates(0.3, 1.0),
      wedge(1.0, 1.0, 1.0), ellipsoid(1.0, 0.5, 0.01, 3), hair(0.5, 6),
      translated(icosphere(1.0, 2), { 1e9, -1e9, 1e9 }), scaled(icosphere(1.0, 2), 1e-9) })
  {
    expectTheSame(mesh, places(mesh));
  }
}

TEST(MeshSearch, FindsSegmentsAndVerticesToo)
{
  const TriangleMesh mesh = makeMesh({ { 0.0, 0.0, 0.0 }, { 1.0, 0.2, 0.0 }, { 0.4, 0.9, 0.1 },
                                       { 0.0, 0.5, 0.8 }, { 1.0, 0.5, 0.7 }, { 0.5, 0.1, 1.0 } },
    { { 0, 1, 2 } }, { { 3, 4 }, { 0, 1 } }, { 5, 2 });
  expectTheSame(mesh, places(mesh));
  const TriangleMesh line = makeMesh({ { 0.0, 0.0, 0.0 }, { 1.0, 0.0, 0.0 } }, {}, { { 0, 1 } });
  expectTheSame(line, places(line));
}

/// From the middle of a sphere all triangles are nearly equally far.
TEST(MeshSearch, FindsTheClosestOfManyThatAreEquallyFar)
{
  const TriangleMesh mesh = icosphere(50.0, 3);
  const Bounds middle{ { -0.5, -0.5, -0.5 }, { 0.5, 0.5, 0.5 } };
  std::vector<Point3> queries = randomPoints(middle, 300, 7);
  queries.push_back({ 0.0, 0.0, 0.0 });
  expectTheSame(mesh, queries);
}
