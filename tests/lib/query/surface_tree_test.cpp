#include "query/surface_tree.h"

#include "support/brute_force.h"
#include "support/shapes.h"
#include "support/transforms.h"

#include <gtest/gtest.h>

#include <vector>

using namespace medial;
using namespace medial::test;

namespace
{

/// A mesh with its tree. World coordinates differ from local ones by the scale only.
struct Surface
{
  explicit Surface(TriangleMesh shape)
    : mesh(std::move(shape))
    , connectivity(analyseConnectivity(mesh))
    , frame(makeGrid(mesh.bounds(), kMaxDimension, 0.0))
    , sites(mesh, connectivity, frame)
    , tree(sites, connectivity)
  {
  }

  void expectExact(const std::vector<Point3>& queries) const
  {
    for (const Point3& query : queries)
    {
      const Hit hit = closestOnMesh(mesh, query);
      const glm::dvec3 x = frame.toFrame(query);
      const SitePoint found = tree.closest(x);
      ASSERT_GE(found.site, 0);
      const double tolerance = 1e-12 * (hit.distance + mesh.bounds().diagonal());
      ASSERT_NEAR(glm::distance(found.point, x) * frame.unit, hit.distance, tolerance);
      ASSERT_NEAR(distanceToSite(mesh, connectivity, found.site, query), hit.distance, tolerance);
      // Nothing is nearer, and something is found with any limit beyond its distance.
      const double distance = glm::distance(found.point, x);
      EXPECT_EQ(tree.closest(x, distance * (1.0 - 1e-9)).site, -1);
      EXPECT_GE(tree.closest(x, distance * (1.0 + 1e-9)).site, 0);
    }
  }

  TriangleMesh mesh;
  MeshConnectivity connectivity;
  GridFrame frame;
  SiteSet sites;
  SurfaceTree tree;
};

void expectExact(const TriangleMesh& mesh)
{
  const Surface surface(mesh);
  Bounds around = surface.mesh.bounds();
  for (int axis = 0; axis < 3; ++axis)
  {
    const double margin = 0.5 * (around.max[axis] - around.min[axis]) + 0.1;
    around.min[axis] -= margin;
    around.max[axis] += margin;
  }
  surface.expectExact(randomPoints(around, 300, 11));
}

} // namespace

TEST(SurfaceTree, IsExactAroundClosedShapes)
{
  expectExact(box({ 1.0, 0.7, 0.4 }));
  expectExact(torus(1.0, 0.3, 40, 20));
  expectExact(icosphere(1.0, 3));
}

TEST(SurfaceTree, IsExactAroundSoupsSegmentsAndPoints)
{
  expectExact(randomSoup(200, 3));
  expectExact(makeMesh({ { 0.0, 0.0, 0.0 }, { 1.0, 0.0, 0.0 }, { 0.0, 1.0, 0.0 }, { 0.0, 0.0, 2.0 },
                         { 1.0, 1.0, 2.0 }, { 3.0, 0.5, 1.0 } },
    { { 0, 1, 2 } }, { { 3, 4 } }, { 5 }));
}

TEST(SurfaceTree, IsExactAroundTrianglesWithoutAreaAndNeedles)
{
  expectExact(makeMesh({ { 0.0, 0.0, 0.0 }, { 1.0, 0.0, 0.0 }, { 2.0, 0.0, 0.0 }, { 0.0, 1.0, 0.0 },
                         { 1.0, 1.0 + 1e-9, 0.0 }, { 2.0, 1.0, 0.5 } },
    { { 0, 1, 2 }, { 3, 4, 5 } }));
}

// Far outside single precision is coarse.
TEST(SurfaceTree, IsExactFromFarAway)
{
  const Surface surface(translated(icosphere(1.0, 3), { 1e4, -2e4, 3e4 }));
  surface.expectExact({ { 0.0, 0.0, 0.0 }, { 1e6, 0.0, 1e6 }, { 1e4, -2e4, 3e4 + 50.0 } });
}

TEST(SurfaceTree, FindsNothingBeyondTheLimit)
{
  const Surface surface(box({ 1.0, 1.0, 1.0 }));
  const glm::dvec3 x = surface.frame.toFrame({ 0.0, 0.0, 3.0 });
  EXPECT_EQ(surface.tree.closest(x, 1.99 / surface.frame.unit).site, -1);
  EXPECT_GE(surface.tree.closest(x, 2.01 / surface.frame.unit).site, 0);
}
