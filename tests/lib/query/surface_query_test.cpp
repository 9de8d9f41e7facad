#include "query/surface_query.h"

#include "support/brute_force.h"
#include "support/shapes.h"
#include "support/transforms.h"

#include <gtest/gtest.h>

#include <array>
#include <chrono>
#include <cmath>
#include <limits>
#include <vector>

using namespace medial;
using namespace medial::test;

namespace
{

struct Surface
{
  explicit Surface(TriangleMesh shape)
    : mesh(std::move(shape))
    , connectivity(analyseConnectivity(mesh))
    , query(mesh, connectivity, 0.0)
  {
  }

  void expectExact(const std::vector<Point3>& positions) const
  {
    for (const Point3& position : positions)
    {
      const Hit hit = closestOnMesh(mesh, position);
      const glm::dvec3 x = query.local().toLocal(position);
      const SitePoint found = query.closest(x);
      ASSERT_GE(found.site, 0);
      const double tolerance = 1e-12 * (hit.distance + mesh.bounds().diagonal());
      ASSERT_NEAR(glm::distance(found.point, x) * query.local().unit, hit.distance, tolerance);
      ASSERT_NEAR(distanceToSite(mesh, connectivity, found.site, position), hit.distance,
        tolerance);
      // Nothing is nearer, and something is found with any limit beyond its distance.
      const double distance = glm::distance(found.point, x);
      EXPECT_EQ(query.closest(x, distance * (1.0 - 1e-9)).site, -1);
      EXPECT_GE(query.closest(x, distance * (1.0 + 1e-9)).site, 0);
    }
  }

  TriangleMesh mesh;
  MeshConnectivity connectivity;
  SurfaceQuery query;
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

TEST(SurfaceQuery, IsExactAroundClosedShapes)
{
  expectExact(box({ 1.0, 0.7, 0.4 }));
  expectExact(torus(1.0, 0.3, 40, 20));
  expectExact(icosphere(1.0, 3));
}

TEST(SurfaceQuery, IsExactAroundSoupsSegmentsAndPoints)
{
  expectExact(randomSoup(200, 3));
  expectExact(makeMesh({ { 0.0, 0.0, 0.0 }, { 1.0, 0.0, 0.0 }, { 0.0, 1.0, 0.0 }, { 0.0, 0.0, 2.0 },
                         { 1.0, 1.0, 2.0 }, { 3.0, 0.5, 1.0 } },
    { { 0, 1, 2 } }, { { 3, 4 } }, { 5 }));
}

TEST(SurfaceQuery, IsExactAroundTrianglesWithoutAreaAndNeedles)
{
  expectExact(makeMesh({ { 0.0, 0.0, 0.0 }, { 1.0, 0.0, 0.0 }, { 2.0, 0.0, 0.0 }, { 0.0, 1.0, 0.0 },
                         { 1.0, 1.0 + 1e-9, 0.0 }, { 2.0, 1.0, 0.5 } },
    { { 0, 1, 2 }, { 3, 4, 5 } }));
}

// Rounding to local coordinates makes the ends of the short edges one, and lets the long edges of
// flat triangles each pass for the longest.
TEST(SurfaceQuery, FindsATubeThatIsThinnerThanRounding)
{
  std::vector<Point3> points;
  std::vector<std::array<std::int64_t, 3>> triangles;
  for (const double x : { 0.0, 1.0 })
  {
    points.insert(points.end(), { { x, 1e-17, 0.0 }, { x, -1e-17, 1e-17 }, { x, 0.0, -1e-17 } });
  }
  for (std::int64_t i = 0; i < 3; ++i)
  {
    const std::int64_t next = (i + 1) % 3;
    triangles.push_back({ i, next, i + 3 });
    triangles.push_back({ next, next + 3, i + 3 });
  }
  points.insert(points.end(), { { 0.0, 0.9, 0.0 }, { 0.0, 1.0, 0.0 }, { 0.0, 0.9, 0.1 } });
  triangles.push_back({ 6, 7, 8 });
  MeshInput input;
  input.points = points;
  for (std::size_t i = 0; i < triangles.size(); ++i)
  {
    input.polygons.append({ triangles[i][0], triangles[i][1], triangles[i][2] },
      static_cast<std::int64_t>(i));
  }
  const TriangleMesh mesh = buildTriangleMesh(input);
  const SurfaceQuery surface(mesh, analyseConnectivity(mesh), 0.0);
  EXPECT_NEAR(surface.distance({ 0.5, 0.0, 0.25 }), 0.25, 1e-12);
}

// Far outside single precision is coarse.
TEST(SurfaceQuery, IsExactFromFarAway)
{
  const Surface surface(translated(icosphere(1.0, 3), { 1e4, -2e4, 3e4 }));
  surface.expectExact({ { 0.0, 0.0, 0.0 }, { 1e6, 0.0, 1e6 }, { 1e4, -2e4, 3e4 + 50.0 } });
}

// There all distances are equal by rounding. What is nearest depends on the direction alone, and is
// not looked for among all sites: that would take minutes here.
TEST(SurfaceQuery, AnswersQuicklyBeyondTheReachOfSinglePrecision)
{
  const TriangleMesh mesh = icosphere(1.0, 6);
  const SurfaceQuery surface(mesh, analyseConnectivity(mesh), 0.0);
  const auto start = std::chrono::steady_clock::now();
  for (const double distance : { 1e16, 1e20, 1e30, 1e100 })
  {
    for (const Point3& p : randomPoints({ { -1.0, -1.0, -1.0 }, { 1.0, 1.0, 1.0 } }, 2000, 5))
    {
      const glm::dvec3 way = glm::normalize(glm::dvec3(p[0], p[1], p[2]));
      const glm::dvec3 x = distance * way;
      ASSERT_NEAR(surface.distance({ x.x, x.y, x.z }) / distance, 1.0, 1e-15);
      const SitePoint found = surface.closest(x / surface.local().unit);
      ASSERT_GE(found.site, 0);
      ASSERT_GT(glm::dot(way, found.point * surface.local().unit), 0.95);
    }
  }
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(20));
}

TEST(SurfaceQuery, FindsNothingBeyondTheLimit)
{
  const Surface surface(box({ 1.0, 1.0, 1.0 }));
  const glm::dvec3 x = surface.query.local().toLocal({ 0.0, 0.0, 3.0 });
  EXPECT_EQ(surface.query.closest(x, 1.99 / surface.query.local().unit).site, -1);
  EXPECT_GE(surface.query.closest(x, 2.01 / surface.query.local().unit).site, 0);
}

TEST(SurfaceQuery, DistancesAgreeWithBruteForce)
{
  for (const TriangleMesh& mesh :
    { shell(0.6, 1.0, 2), lPrism(1.0, 0.5), randomSoup(300, 4), plates(0.4, 1.0) })
  {
    const SurfaceQuery surface(mesh, analyseConnectivity(mesh), 0.0);
    const auto points = randomPoints({ { -1.5, -1.5, -1.5 }, { 1.5, 1.5, 1.5 } }, 1000, 9);
    const auto hits = closestOnMesh(mesh, points);
    for (std::size_t i = 0; i < points.size(); ++i)
    {
      ASSERT_NEAR(surface.distance(points[i]), hits[i].distance, 1e-9);
    }
  }
}

TEST(SurfaceQuery, LinesAndPointsCount)
{
  MeshInput input;
  input.points = { { 0, 0, 0 }, { 1, 0, 0 }, { 5, 5, 5 } };
  input.lines.append({ 0, 1 }, 0);
  input.verts.append({ 2 }, 1);
  const TriangleMesh mesh = buildTriangleMesh(input);
  const SurfaceQuery surface(mesh, analyseConnectivity(mesh), 0.0);
  EXPECT_NEAR(surface.distance({ 0.5, 2.0, 0.0 }), 2.0, 1e-12);
  EXPECT_NEAR(surface.distance({ 5.0, 5.0, 8.0 }), 3.0, 1e-12);
}

TEST(SurfaceQuery, NothingIsAtAnInfiniteDistance)
{
  const TriangleMesh mesh = box({ 1.0, 1.0, 1.0 });
  const SurfaceQuery surface(mesh, analyseConnectivity(mesh), 0.0);
  const double unknown = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(std::isinf(surface.distance({ unknown, 0.0, 0.0 })));
  const double infinite = std::numeric_limits<double>::infinity();
  EXPECT_TRUE(std::isinf(surface.distance({ infinite, 0.0, 0.0 })));
}
