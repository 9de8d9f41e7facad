// What the header says of meshes that only touch, are open, or are hardly meshes.
#include "medial/proximity.h"

#include "lib/proximity/proximity_checks.h"
#include "lib/proximity/proximity_oracle.h"
#include "support/brute_force.h"
#include "support/shapes.h"
#include "support/transforms.h"
#include "support/uneven_meshes.h"

#include <glm/glm.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

namespace medial::test
{
namespace
{

TriangleMesh octahedron(const Point3& centre)
{
  std::vector<Point3> points;
  for (int i = 0; i < 6; ++i)
  {
    points.push_back(centre);
    points.back()[i / 2] += i % 2 == 0 ? 1.0 : -1.0;
  }
  return makeMesh(points,
    { { 0, 2, 4 }, { 2, 1, 4 }, { 1, 3, 4 }, { 3, 0, 4 }, { 2, 0, 5 }, { 1, 2, 5 }, { 3, 1, 5 },
      { 0, 3, 5 } });
}

TriangleMesh triangle(const Point3& a, const Point3& b, const Point3& c)
{
  return makeMesh({ a, b, c }, { { 0, 1, 2 } });
}

TriangleMesh segment(const Point3& a, const Point3& b)
{
  return makeMesh({ a, b }, {}, { { 0, 1 } });
}

TriangleMesh point(const Point3& a)
{
  return makeMesh({ a }, {}, {}, { 0 });
}

/// A box without its lid.
TriangleMesh openBox(const Point3& halfSides)
{
  const TriangleMesh closed = box(halfSides);
  std::vector<std::array<int, 3>> triangles;
  for (const auto& t : closed.triangles)
  {
    const auto isUp = [&](int id) { return closed.points[id][2] > 0.0; };
    if (!(isUp(t[0]) && isUp(t[1]) && isUp(t[2])))
    {
      triangles.push_back(t);
    }
  }
  return makeMesh(closed.points, triangles);
}

void expectTouching(const Proximity& found)
{
  EXPECT_TRUE(found.intersect);
  EXPECT_TRUE(found.collide);
  EXPECT_EQ(found.separation, 0.0);
  EXPECT_EQ(found.witnessA, found.witnessB);
  EXPECT_NEAR(found.depth, 0.0, 1e-15);
  EXPECT_NEAR(found.translationalDepth.lower, 0.0, 1e-15);
}

TEST(ProximityDegenerate, TouchingAtACornerIsAnIntersection)
{
  const TriangleMesh low = octahedron({ 0.0, 0.0, 0.0 });
  const Proximity found = computeProximity(low, octahedron({ 0.0, 0.0, 2.0 }));
  expectTouching(found);
  EXPECT_EQ(found.witnessA, (Point3{ 0.0, 0.0, 1.0 }));
  const double ulp = std::numeric_limits<double>::epsilon();
  EXPECT_FALSE(computeProximity(low, octahedron({ 0.0, 0.0, 2.0 + 2.0 * ulp })).collide);
  EXPECT_TRUE(computeProximity(low, octahedron({ 0.0, 0.0, 2.0 - 2.0 * ulp })).collide);
}

TEST(ProximityDegenerate, TouchingOfEdgesIsAnIntersection)
{
  // Edges along y and along x that cross at the origin.
  const TriangleMesh ridge = makeMesh(
    { { 0, -1, 0 }, { 0, 1, 0 }, { -1, -1, -1 }, { -1, 1, -1 }, { 1, -1, -1 }, { 1, 1, -1 } },
    { { 0, 1, 3 }, { 0, 3, 2 }, { 0, 4, 5 }, { 0, 5, 1 }, { 2, 3, 5 }, { 2, 5, 4 }, { 0, 2, 4 },
      { 1, 5, 3 } });
  const TriangleMesh keel = rotated90(rotated90(rotated90(ridge, 2), 0), 0);
  const Proximity found = computeProximity(ridge, keel);
  expectTouching(found);
  EXPECT_EQ(found.witnessA, (Point3{ 0.0, 0.0, 0.0 }));
  EXPECT_FALSE(computeProximity(ridge, translated(keel, { 0.0, 0.0, 0x1p-50 })).collide);
  EXPECT_TRUE(computeProximity(ridge, translated(keel, { 0.0, 0.0, -0x1p-50 })).collide);
}

TEST(ProximityDegenerate, CoincidentFacesAreAnIntersection)
{
  const TriangleMesh cube = box({ 1.0, 1.0, 1.0 });
  for (const Point3& offset : { Point3{ 2.0, 0.0, 0.0 }, Point3{ 0.0, -2.0, 0.5 },
         Point3{ 2.0, 2.0, 0.0 }, Point3{ 2.0, -2.0, 2.0 } })
  {
    expectTouching(computeProximity(cube, translated(cube, offset)));
  }
  // One that lies inside with a face on the other's face.
  const Proximity found =
    computeProximity(translated(box({ 0.25, 0.25, 0.25 }), { 0.75, 0.0, 0.0 }), cube);
  EXPECT_TRUE(found.intersect);
  EXPECT_NEAR(found.depth, 0.5, 1e-3);
}

TEST(ProximityDegenerate, AMeshIntersectsItself)
{
  for (const TriangleMesh& mesh : { box({ 1.0, 0.5, 0.25 }), icosphere(1.0, 2), randomSoup(20, 1),
         segment({ 0, 0, 0 }, { 1, 2, 3 }), point({ 0.1, 0.2, 0.3 }) })
  {
    const Proximity found = computeProximity(mesh, mesh);
    EXPECT_TRUE(found.intersect);
    EXPECT_TRUE(found.collide);
    EXPECT_EQ(found.separation, 0.0);
    if (!found.insideUndefined)
    {
      EXPECT_NEAR(found.depth, 0.0, 1e-12);
    }
  }
}

TEST(ProximityDegenerate, TrianglesAreSeparatedLikeOthers)
{
  const TriangleMesh flat = triangle({ 0, 0, 0 }, { 4, 0, 0 }, { 0, 4, 0 });
  const Proximity above = computeProximity(flat, triangle({ 1, 1, 0.5 }, { 2, 1, 1 }, { 1, 2, 3 }));
  EXPECT_FALSE(above.collide);
  EXPECT_NEAR(above.separation, 0.5, 1e-15);
  EXPECT_EQ(above.witnessA, (Point3{ 1.0, 1.0, 0.0 }));
  EXPECT_EQ(above.witnessB, (Point3{ 1.0, 1.0, 0.5 }));
  EXPECT_EQ(above.depth, 0.0);
  const Proximity across =
    computeProximity(flat, triangle({ 1, 1, -1 }, { 1, 1, 1 }, { 9, 9, 0.25 }));
  EXPECT_TRUE(across.intersect);
  EXPECT_TRUE(across.collide);
  EXPECT_EQ(std::isnan(across.depth), across.insideUndefined);
  const Proximity coplanar =
    computeProximity(flat, triangle({ 3, 3, 0 }, { 6, 3, 0 }, { 3, 6, 0 }));
  EXPECT_FALSE(coplanar.collide);
  EXPECT_NEAR(coplanar.separation, std::sqrt(2.0), 1e-15);
}

/// The least distance of places on the segments and of the points of a mesh from another: too large
/// by up to the step.
double sampledSeparation(const TriangleMesh& cells, const TriangleMesh& other, int steps)
{
  double least = std::numeric_limits<double>::infinity();
  const auto look = [&](const Point3& place)
  { least = std::min(least, closestOnMesh(other, place).distance); };
  for (const int id : cells.vertices)
  {
    look(cells.points[id]);
  }
  for (const auto& [p, q] : cells.segments)
  {
    for (int i = 0; i <= steps; ++i)
    {
      const double t = static_cast<double>(i) / steps;
      const Point3& from = cells.points[p];
      const Point3& to = cells.points[q];
      look({ from[0] + t * (to[0] - from[0]), from[1] + t * (to[1] - from[1]),
        from[2] + t * (to[2] - from[2]) });
    }
  }
  return least;
}

TEST(ProximityDegenerate, SegmentsAndPointsAreSeparatedLikeTriangles)
{
  const TriangleMesh cells = scatteredSegmentsAndVertices(40, 10.0);
  for (const Point3& offset : { Point3{ 30.0, 1.0, 2.0 }, Point3{ 0.5, 0.25, 0.75 } })
  {
    const TriangleMesh others = translated(rotated90(cells, 1), offset);
    const Proximity found = computeProximity(cells, others);
    constexpr int kSteps = 300;
    constexpr double kStep = 20.0 * 1.8 / kSteps;
    const double expected = sampledSeparation(cells, others, kSteps);
    EXPECT_FALSE(found.collide);
    EXPECT_LE(found.separation, expected + 1e-12);
    EXPECT_GE(found.separation, expected - kStep);
    EXPECT_NEAR(distanceToCell(cells, found.cellA, found.witnessA), 0.0, 1e-12);
    EXPECT_NEAR(distanceToCell(others, found.cellB, found.witnessB), 0.0, 1e-12);
  }
}

TEST(ProximityDegenerate, SegmentsAndPointsHaveNoSolidButMayBeInside)
{
  const TriangleMesh cube = box({ 1.0, 1.0, 1.0 });
  const Proximity spot = computeProximity(point({ 0.5, 0.25, 0.0 }), cube);
  EXPECT_FALSE(spot.intersect);
  EXPECT_TRUE(spot.collide);
  EXPECT_NEAR(spot.separation, 0.5, 1e-15);
  EXPECT_NEAR(spot.depth, 0.5, 1e-15);
  ASSERT_EQ(spot.depthsOfA.size(), 1u);
  EXPECT_TRUE(spot.depthsOfB.empty());
  const Proximity inside = computeProximity(segment({ -0.5, 0, 0 }, { 0.25, 0, 0 }), cube);
  EXPECT_TRUE(inside.collide);
  EXPECT_NEAR(inside.separation, 0.5, 1e-15);
  EXPECT_NEAR(inside.depth, 1.0, 1e-3);
  const Proximity through = computeProximity(segment({ -3, 0.5, 0 }, { 4, 0.5, 0 }), cube);
  EXPECT_TRUE(through.intersect);
  EXPECT_NEAR(through.depth, 0.5, 1e-3);
  EXPECT_TRUE(through.depthsOfA.empty());
  EXPECT_FALSE(computeProximity(point({ 1.0, 1.0, 1.5 }), cube).collide);
  EXPECT_TRUE(computeProximity(point({ 1.0, 0.5, 0.25 }), cube).intersect);
  EXPECT_TRUE(computeProximity(point({ 1, 2, 3 }), point({ 1, 2, 3 })).intersect);
  EXPECT_FALSE(computeProximity(point({ 1, 2, 3 }), point({ 1, 2, 3.5 })).collide);
}

TEST(ProximityDegenerate, SegmentsAndPointsInASolidAreAsDeepAsTheirPlaces)
{
  const TriangleMesh cells = normalised(scatteredSegmentsAndVertices(30, 1.0));
  RandomMotions motions(9);
  for (int i = 0; i < 20; ++i)
  {
    SCOPED_TRACE(i);
    const TriangleMesh a = snapped(moved(cells, motions.motion(1.0)));
    const TriangleMesh b = snapped(moved(normalised(roughSphere(1.0, 2, 0.3)), motions.rotation()));
    const std::vector<PointDepth> expected = SolidOracle(b).depthsOf(a);
    const Proximity found = computeProximity(a, b);
    EXPECT_EQ(found.collide, found.intersect || !expected.empty());
    EXPECT_TRUE(found.depthsOfB.empty());
    ASSERT_EQ(found.depthsOfA.size(), expected.size());
    for (std::size_t k = 0; k < expected.size(); ++k)
    {
      EXPECT_EQ(found.depthsOfA[k].point, expected[k].point);
      EXPECT_NEAR(found.depthsOfA[k].depth, expected[k].depth, 1e-12);
      EXPECT_GE(found.depth, expected[k].depth - 1e-12);
    }
    expectSame(mirrored(computeProximity(b, a)), found);
  }
}

TEST(ProximityDegenerate, SegmentsOfTheSamePointsAreMirrored)
{
  const std::vector<Point3> points{ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0.5 }, { 1, 1, 0.5 },
    { 0.5, 0.5, 3 } };
  const TriangleMesh a = makeMesh(points, {}, { { 0, 1 }, { 1, 4 }, { 4, 0 } });
  const TriangleMesh b = makeMesh(points, {}, { { 2, 3 }, { 3, 4 }, { 4, 2 } });
  expectSame(mirrored(computeProximity(b, a)), computeProximity(a, b));
}

TEST(ProximityDegenerate, TrianglesFacingInwardsAreTheSameSolid)
{
  const TriangleMesh cube = box({ 1.0, 1.0, 1.0 });
  const TriangleMesh ball = translated(icosphere(0.5, 2), { 0.8, 0.1, 0.2 });
  const Proximity expected = computeProximity(ball, cube);
  const Proximity found = computeProximity(flipOrientation(ball), flipOrientation(cube));
  EXPECT_EQ(found.depthsOfA.size(), expected.depthsOfA.size());
  EXPECT_NEAR(found.depth, expected.depth, 1e-3 * expected.depth);
}

/// Most of what is around the middle of an open box is the box: inside; far above the rim, outside.
TEST(ProximityDegenerate, AnOpenMeshHoldsWhatItsWindingNumberSays)
{
  const TriangleMesh tub = openBox({ 1.0, 1.0, 2.0 });
  const TriangleMesh ball = icosphere(0.25, 1);
  const Proximity deep = computeProximity(translated(ball, { 0.0, 0.0, -1.0 }), tub);
  EXPECT_FALSE(deep.intersect);
  EXPECT_TRUE(deep.collide);
  EXPECT_FALSE(deep.insideUndefined);
  EXPECT_EQ(deep.depthsOfA.size(), ball.points.size());
  EXPECT_NEAR(deep.separation, 0.75, 0.02);
  const Proximity above = computeProximity(translated(ball, { 0.0, 0.0, 4.0 }), tub);
  EXPECT_FALSE(above.collide);
  EXPECT_FALSE(above.insideUndefined);
  EXPECT_EQ(above.depth, 0.0);
}

/// At the opening the winding number is about a half.
TEST(ProximityDegenerate, AnOpenMeshLeavesOpenWhatIsInsideAtItsOpening)
{
  const TriangleMesh tub = openBox({ 1.0, 1.0, 2.0 });
  const TriangleMesh ball = translated(icosphere(0.1, 1), { 0.0, 0.0, 1.85 });
  const Proximity found = computeProximity(ball, tub);
  EXPECT_FALSE(found.intersect);
  EXPECT_TRUE(found.insideUndefined);
  EXPECT_TRUE(std::isnan(found.depth));
  const Proximity across = computeProximity(translated(icosphere(0.3, 1), { 0.8, 0, 1.9 }), tub);
  EXPECT_TRUE(across.intersect);
  EXPECT_TRUE(across.collide);
  EXPECT_TRUE(across.insideUndefined);
  EXPECT_TRUE(std::isnan(across.depth));
}

/// A bar that reaches through the opening without touching: its ends are inside and outside,
/// whichever of them has the lower ids.
TEST(ProximityDegenerate, ABarThroughAnOpeningIsInsideWithOneEnd)
{
  const TriangleMesh tub = openBox({ 1.0, 1.0, 2.0 });
  const TriangleMesh bar = subdivided(box({ 0.2, 0.2, 3.0 }), 3);
  for (const TriangleMesh& mesh : { bar, mirrored(bar, 2) })
  {
    const Proximity found = computeProximity(translated(mesh, { 0.0, 0.0, 2.0 }), tub);
    EXPECT_FALSE(found.intersect);
    EXPECT_TRUE(found.collide);
    EXPECT_TRUE(found.insideUndefined);
    EXPECT_TRUE(std::isnan(found.depth));
  }
}

/// A corner of the oracle's lattice next to a face, by random search: hardly inside or outside.
Point3 nextToFace(const TriangleMesh& mesh, std::mt19937& random)
{
  const auto& [a, b, c] = mesh.triangles[0];
  const auto at = [&](int id)
  { return glm::dvec3(mesh.points[id][0], mesh.points[id][1], mesh.points[id][2]); };
  using Exact = glm::tvec3<long double>;
  const Exact normal = glm::cross(Exact(at(b)) - Exact(at(a)), Exact(at(c)) - Exact(at(a)));
  std::uniform_real_distribution<double> share(0.1, 0.4);
  Point3 best{};
  long double nearest = std::numeric_limits<long double>::infinity();
  for (int i = 0; i < 3000; ++i)
  {
    const glm::dvec3 x = at(a) + share(random) * (at(b) - at(a)) + share(random) * (at(c) - at(a));
    const Point3 place = snapped(Point3{ x.x, x.y, x.z });
    const Exact from = Exact(place[0], place[1], place[2]) - Exact(at(a));
    const long double height = std::abs(glm::dot(normal, from));
    if (height < nearest)
    {
      nearest = height;
      best = place;
    }
  }
  return best;
}

/// A spike whose tip is about 1e-17 from a slanted face, and the rest outside.
TEST(ProximityDegenerate, ACornerHardlyOutsideAFaceDoesNotCollide)
{
  std::mt19937 random(1);
  RandomMotions motions(2);
  int intersecting = 0;
  for (int i = 0; i < 400; ++i)
  {
    const TriangleMesh solid =
      snapped(moved(normalised(regularTetrahedron(1.0)), motions.rotation()));
    const Point3 tip = nextToFace(solid, random);
    const auto& [a, b, c] = solid.triangles[0];
    const Point3& far = solid.points[6 - a - b - c]; // the other corner
    std::vector<Point3> points{ tip };
    for (const Point3& step : motions.rotation().rows)
    {
      Point3& corner = points.emplace_back();
      for (std::size_t axis = 0; axis < 3; ++axis)
      {
        corner[axis] = tip[axis] - 0.5 * (far[axis] - tip[axis]) + 0.2 * step[axis];
      }
    }
    const TriangleMesh spike =
      snapped(makeMesh(points, { { 0, 1, 2 }, { 0, 2, 3 }, { 0, 3, 1 }, { 1, 3, 2 } }));
    const bool expected = surfacesIntersect(spike, solid);
    intersecting += expected ? 1 : 0;
    const Proximity found = computeProximity(spike, solid);
    EXPECT_EQ(found.intersect, expected);
    EXPECT_EQ(found.collide, expected);
    EXPECT_EQ(found.separation == 0.0, expected);
  }
  EXPECT_GT(intersecting, 100);
  EXPECT_LT(intersecting, 300);
}

TEST(ProximityDegenerate, TinyCoordinatesAreExactToo)
{
  const TriangleMesh cube = box({ 1.0, 1.0, 1.0 });
  for (const double tiny : { 1e-20, 1e-50, 1e-69 })
  {
    SCOPED_TRACE(tiny);
    const TriangleMesh flat = triangle({ 0, 0, 0 }, { 4, 0, 0 }, { 0, 4, 0 });
    const auto spike = [](double z) { return triangle({ 1, 1, z }, { 3, 1, 5 }, { 1, 2, 7 }); };
    EXPECT_FALSE(computeProximity(flat, spike(tiny)).intersect);
    EXPECT_TRUE(computeProximity(flat, spike(-tiny)).intersect);
    const TriangleMesh low = translated(cube, { 0.0, 0.0, -1.0 });
    TriangleMesh high = translated(cube, { 0.25, 0.5, 1.0 });
    for (Point3& p : high.points)
    {
      p[2] = p[2] == 0.0 ? tiny : p[2];
    }
    EXPECT_FALSE(computeProximity(low, high).collide);
    EXPECT_GT(computeProximity(low, high).separation, 0.0);
  }
}

} // namespace
} // namespace medial::test
