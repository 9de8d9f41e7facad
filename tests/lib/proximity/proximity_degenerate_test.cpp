// What the header says of meshes that only touch, are open, or are hardly meshes.
#include "medial/proximity.h"

#include "lib/proximity/proximity_checks.h"
#include "support/brute_force.h"
#include "support/shapes.h"
#include "support/transforms.h"
#include "support/uneven_meshes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
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

TEST(ProximityDegenerate, SegmentsAndPointsAreSeparatedLikeTriangles)
{
  const TriangleMesh cells = scatteredSegmentsAndVertices(40, 10.0);
  const TriangleMesh far = translated(cells, { 30.0, 1.0, 2.0 });
  double expected = std::numeric_limits<double>::infinity();
  const Proximity found = computeProximity(cells, far);
  for (int i = 0; i <= 1000; ++i)
  {
    for (const auto& [p, q] : cells.segments)
    {
      Point3 place;
      for (std::size_t axis = 0; axis < 3; ++axis)
      {
        place[axis] =
          cells.points[p][axis] + i / 1000.0 * (cells.points[q][axis] - cells.points[p][axis]);
      }
      expected = std::min(expected, closestOnMesh(far, place).distance);
    }
  }
  EXPECT_FALSE(found.collide);
  EXPECT_LE(found.separation, expected + 1e-12);
  EXPECT_GE(found.separation, expected - 0.02);
  EXPECT_NEAR(distanceToCell(cells, found.cellA, found.witnessA), 0.0, 1e-12);
  EXPECT_NEAR(distanceToCell(far, found.cellB, found.witnessB), 0.0, 1e-12);
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

/// A bar that reaches through the opening without touching: its ends are inside and outside, and
/// which of them has the lower ids does not matter.
TEST(ProximityDegenerate, ABarThroughAnOpeningIsInsideWithOneEnd)
{
  const TriangleMesh tub = openBox({ 1.0, 1.0, 2.0 });
  const TriangleMesh bar = subdivided(translated(box({ 0.2, 0.2, 3.0 }), { 0.0, 0.0, 2.0 }), 3);
  for (const TriangleMesh& mesh : { bar, mirrored(translated(bar, { 0, 0, -4 }), 2) })
  {
    const TriangleMesh placed = mesh.points == bar.points ? mesh : translated(mesh, { 0, 0, 4 });
    const Proximity found = computeProximity(placed, tub);
    EXPECT_FALSE(found.intersect);
    EXPECT_TRUE(found.collide);
    EXPECT_TRUE(found.insideUndefined);
  }
}

TEST(ProximityDegenerate, TinyCoordinatesAreExactToo)
{
  const TriangleMesh cube = box({ 1.0, 1.0, 1.0 });
  for (const double tiny : { 1e-20, 1e-80, 1e-160, 1e-300 })
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
