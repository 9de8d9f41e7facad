// Points that are mirrored while the cells stay: what faced outwards then faces inwards.
#include "medial/field_proximity.h"
#include "medial/proximity.h"

#include "support/shapes.h"
#include "support/transforms.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <vector>

namespace medial::test
{
namespace
{

constexpr double kRounding = 1e-12;

/// The points mirrored in the plane x = `middle`, where `chosen` holds.
std::vector<Point3> mirroredPoints(const TriangleMesh& mesh, double middle,
  const std::function<bool(const Point3&)>& chosen = {})
{
  std::vector<Point3> points = mesh.points;
  for (Point3& point : points)
  {
    point[0] = !chosen || chosen(point) ? 2.0 * middle - point[0] : point[0];
  }
  return points;
}

TriangleMesh withPoints(TriangleMesh mesh, const std::vector<Point3>& points)
{
  mesh.points = points;
  return mesh;
}

void expectAsFresh(const Proximity& found, const TriangleMesh& a, const TriangleMesh& b)
{
  const Proximity fresh = computeProximity(a, b);
  EXPECT_EQ(found.intersect, fresh.intersect);
  EXPECT_EQ(found.collide, fresh.collide);
  EXPECT_EQ(found.insideUndefined, fresh.insideUndefined);
  EXPECT_NEAR(found.separation, fresh.separation, kRounding);
  EXPECT_NEAR(found.depth, fresh.depth, 1e-3 * fresh.depth);
  EXPECT_EQ(found.depthsOfA.size(), fresh.depthsOfA.size());
  EXPECT_EQ(found.depthsOfB.size(), fresh.depthsOfB.size());
  EXPECT_EQ(found.contacts.size(), fresh.contacts.size());
}

/// Mirrored, the cube is the same cube.
TEST(ProximityMirror, ACubeInACube)
{
  const TriangleMesh large = box({ 1.0, 1.0, 1.0 });
  const TriangleMesh small = box({ 0.25, 0.25, 0.25 });
  ProximitySolver solver({ large, small });
  for (const bool mirror : { true, false, true })
  {
    SCOPED_TRACE(mirror);
    solver.setPoints(0, mirror ? mirroredPoints(large, 0.0) : large.points);
    const Proximity& found = solver.compute().front();
    EXPECT_FALSE(found.intersect);
    EXPECT_TRUE(found.collide);
    EXPECT_NEAR(found.separation, 0.75, kRounding);
    EXPECT_NEAR(found.depth, 0.75, 1e-3);
    EXPECT_NEAR(found.translationalDepth.lower, 1.25, 1e-7);
    EXPECT_NEAR(found.translationalDepth.upper, 1.25, 1e-7);
    expectAsFresh(found, solver.mesh(0), solver.mesh(1));
  }
}

TEST(ProximityMirror, BothOfTwoBoxes)
{
  const TriangleMesh a = box({ 1.0, 1.0, 1.0 });
  const TriangleMesh b = translated(a, { 1.8, 0.0, 0.0 });
  ProximitySolver solver({ a, b });
  for (const bool mirror : { true, false })
  {
    SCOPED_TRACE(mirror);
    solver.setPoints(0, mirror ? mirroredPoints(a, 0.0) : a.points);
    solver.setPoints(1, mirror ? mirroredPoints(b, 0.0) : b.points);
    const Proximity& found = solver.compute().front();
    EXPECT_TRUE(found.collide);
    EXPECT_NEAR(found.depth, 0.2, 1e-3);
    EXPECT_NEAR(found.translationalDepth.lower, 0.2, 1e-7);
    EXPECT_NEAR(found.translationalDepth.upper, 0.2, 1e-7);
    EXPECT_NEAR(found.separatingTranslation[0], mirror ? 0.2 : -0.2, 1e-7);
  }
}

TEST(ProximityMirror, DepthsOfPoints)
{
  const TriangleMesh a = translated(box({ 0.5, 0.5, 0.5 }), { 0.5, 0.5, 0.5 });
  const TriangleMesh b = translated(box({ 0.6, 0.6, 0.85 }), { 1.4, 1.4, 1.65 });
  ProximitySolver solver({ a, b });
  solver.setPoints(1, mirroredPoints(b, 1.4));
  const Proximity& found = solver.compute().front();
  ASSERT_EQ(found.depthsOfA.size(), 1u); // the corner (1, 1, 1)
  EXPECT_NEAR(found.depthsOfA.front().depth, 0.2, kRounding);
  ASSERT_EQ(found.depthsOfB.size(), 1u); // the corner (0.8, 0.8, 0.8)
  EXPECT_NEAR(found.depthsOfB.front().depth, 0.2, kRounding);
  expectAsFresh(found, solver.mesh(0), solver.mesh(1));
}

/// One of two cubes is mirrored; the small one is in either.
TEST(ProximityMirror, OneOfTwoParts)
{
  const TriangleMesh cube = box({ 1.0, 1.0, 1.0 });
  const TriangleMesh pair =
    appended(translated(cube, { -3.0, 0.0, 0.0 }), translated(cube, { 3.0, 0.0, 0.0 }));
  const TriangleMesh small = box({ 0.25, 0.25, 0.25 });
  ProximitySolver solver({ pair, small });
  solver.setPoints(0, mirroredPoints(pair, 3.0, [](const Point3& p) { return p[0] > 0.0; }));
  for (const double x : { -3.0, 0.0, 3.0 })
  {
    SCOPED_TRACE(x);
    solver.setPoints(1, translated(small, { x, 0.0, 0.0 }).points);
    const Proximity& found = solver.compute().front();
    EXPECT_EQ(found.collide, x != 0.0);
    EXPECT_NEAR(found.separation, x != 0.0 ? 0.75 : 1.75, kRounding);
    EXPECT_NEAR(found.depth, x != 0.0 ? 0.75 : 0.0, 1e-3);
    expectAsFresh(found, solver.mesh(0), solver.mesh(1));
  }
}

/// A cavity stays one if its surface is mirrored with the outer one.
TEST(ProximityMirror, AShellWithACavity)
{
  const TriangleMesh hollow = shell(1.0, 1.5, 4);
  const TriangleMesh ball = icosphere(0.2, 3);
  constexpr double kSag = 2e-3; // faces lie inside the spheres by less
  ProximitySolver solver({ hollow, ball });
  for (const bool mirror : { true, false })
  {
    solver.setPoints(0, mirror ? mirroredPoints(hollow, 0.0) : hollow.points);
    for (const double x : { 0.0, 0.9, 1.25 })
    {
      SCOPED_TRACE(x);
      solver.setPoints(1, translated(ball, { x, 0.0, 0.0 }).points);
      const Proximity& found = solver.compute().front();
      EXPECT_EQ(found.collide, x != 0.0);
      EXPECT_NEAR(found.separation, x == 0.0 ? 0.8 : (x == 0.9 ? 0.0 : 0.05), kSag);
      EXPECT_NEAR(found.depth, x == 0.0 ? 0.0 : (x == 0.9 ? 0.1 : 0.25), kSag);
    }
  }
}

/// Winding numbers tell the inside of a surface with a hole.
TEST(ProximityMirror, ASurfaceWithAHole)
{
  TriangleMesh open = icosphere(1.0, 2);
  open.triangles.pop_back();
  open.triangleCells.pop_back();
  const TriangleMesh small = box({ 0.2, 0.2, 0.2 });
  ProximitySolver solver({ open, small });
  for (const bool mirror : { true, false })
  {
    SCOPED_TRACE(mirror);
    solver.setPoints(0, mirror ? mirroredPoints(open, 0.0) : open.points);
    const Proximity& found = solver.compute().front();
    EXPECT_TRUE(found.collide);
    EXPECT_EQ(found.depthsOfB.size(), 8u);
    expectAsFresh(found, solver.mesh(0), solver.mesh(1));
  }
}

TEST(ProximityMirror, FieldsAgree)
{
  const TriangleMesh large = box({ 1.0, 1.0, 1.0 });
  const TriangleMesh small = box({ 0.25, 0.25, 0.25 });
  FieldProximitySolver solver(large, small);
  for (const bool mirror : { true, false })
  {
    solver.setPoints(0, mirror ? mirroredPoints(large, 0.0) : large.points);
    EXPECT_TRUE(solver.compute().collide) << mirror;
  }
}

/// What solids contain each other in the positions of now counts, not in the first ones.
TEST(ProximityMirror, APartThatLeavesAnother)
{
  const TriangleMesh outer = box({ 2.0, 2.0, 2.0 });
  const TriangleMesh cavity = flipOrientation(box({ 1.0, 1.0, 1.0 }));
  const TriangleMesh small = box({ 0.25, 0.25, 0.25 });
  const TriangleMesh hollow = appended(outer, cavity);
  ProximitySolver solver({ hollow, small });
  EXPECT_FALSE(solver.compute().front().collide);
  std::vector<Point3> apart = hollow.points;
  for (std::size_t i = outer.points.size(); i < apart.size(); ++i)
  {
    apart[i][0] += 10.0;
  }
  solver.setPoints(0, apart);
  solver.setPoints(1, translated(small, { 10.0, 0.0, 0.0 }).points);
  const Proximity& found = solver.compute().front();
  EXPECT_TRUE(found.collide);
  EXPECT_NEAR(found.depth, 0.75, 1e-3);
  expectAsFresh(found, withPoints(hollow, apart), solver.mesh(1));
}

} // namespace
} // namespace medial::test
