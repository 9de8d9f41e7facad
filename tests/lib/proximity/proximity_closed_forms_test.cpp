// Pairs whose separation and depth have closed forms.
#include "medial/proximity.h"

#include "support/shapes.h"
#include "support/transforms.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace medial::test
{
namespace
{

constexpr double kRounding = 1e-12;
const double kPi = std::acos(-1.0);

/// Faces of an icosphere of radius 1 lie inside by less.
constexpr double sagOf(int subdivisions)
{
  return 0.2 / static_cast<double>(1 << (2 * subdivisions));
}

void expectApart(const Proximity& found, double separation, double tolerance)
{
  EXPECT_FALSE(found.intersect);
  EXPECT_FALSE(found.collide);
  EXPECT_FALSE(found.insideUndefined);
  EXPECT_NEAR(found.separation, separation, tolerance);
  EXPECT_EQ(found.depth, 0.0);
  EXPECT_EQ(found.translationalDepth.lower, 0.0);
  EXPECT_EQ(found.translationalDepth.upper, 0.0);
  EXPECT_TRUE(found.depthsOfA.empty());
  EXPECT_TRUE(found.depthsOfB.empty());
  EXPECT_TRUE(found.contacts.empty());
}

void expectIntersecting(const Proximity& found, double depth, double tolerance)
{
  EXPECT_TRUE(found.intersect);
  EXPECT_TRUE(found.collide);
  EXPECT_EQ(found.separation, 0.0);
  EXPECT_EQ(found.witnessA, found.witnessB);
  EXPECT_LE(found.depth, depth + tolerance);
  EXPECT_GE(found.depth, depth * (1.0 - ProximityOptions().depthTolerance) - tolerance);
}

TEST(ProximityClosedForms, OfTwoBalls)
{
  constexpr int kSubdivisions = 4;
  const double r = 1.0;
  const double s = 0.6;
  const double sag = 2.0 * sagOf(kSubdivisions);
  const TriangleMesh ball = icosphere(r, kSubdivisions);
  for (const double distance : { 0.3, 0.5, 0.9, 1.2, 1.5, 1.7, 2.5 })
  {
    SCOPED_TRACE(distance);
    const Point3 direction{ 0.36, 0.48, 0.8 };
    const TriangleMesh other = translated(icosphere(s, kSubdivisions),
      { distance * direction[0], distance * direction[1], distance * direction[2] });
    const Proximity found = computeProximity(ball, other);
    const bool nested = distance < r - s;
    EXPECT_EQ(found.collide, distance < r + s);
    EXPECT_EQ(found.intersect, !nested && distance < r + s);
    EXPECT_NEAR(found.separation, std::max({ 0.0, distance - r - s, r - s - distance }), sag);
    // The sphere's place closest to the other's centre is the deepest.
    const double inBall = r - std::abs(distance - s);
    const double inOther = s - std::abs(distance - r);
    const double depth = std::max({ 0.0, inBall, inOther });
    EXPECT_NEAR(found.depth, depth, sag + 1e-3 * depth);
  }
}

/// A solid with a feature that points up at the origin.
struct Tip
{
  const char* name;
  TriangleMesh mesh;
};

/// Boxes with a face, an edge or a corner up.
std::vector<Tip> tips()
{
  const TriangleMesh cube = box({ 0.5, 0.5, 0.5 });
  const TriangleMesh edge = turned(cube, 0, kPi / 4.0);
  return { { "face", translated(cube, { 0.1, 0.2, -0.5 }) },
    { "edge", translated(edge, { 0.1, 0.0, -std::sqrt(0.5) }) },
    { "corner",
      translated(turned(edge, 1, std::atan(std::sqrt(0.5))), { 0.0, 0.0, -std::sqrt(0.75) }) } };
}

/// The same pointing down at a height; turned, so that edges cross.
TriangleMesh upsideDown(const TriangleMesh& tip, double height)
{
  return translated(turned(turned(tip, 0, kPi), 2, 1.2), { 0.0, 0.0, height });
}

TEST(ProximityClosedForms, OfBoxesInAllTypesOfContact)
{
  for (const Tip& lower : tips())
  {
    for (const Tip& upper : tips())
    {
      for (const double gap : { 1.0, 1e-3, 1e-9 })
      {
        SCOPED_TRACE(std::string(upper.name) + " on " + lower.name + ", " + std::to_string(gap));
        expectApart(computeProximity(upsideDown(upper.mesh, gap), lower.mesh), gap, kRounding);
        const Proximity sunk = computeProximity(upsideDown(upper.mesh, -0.1 * gap), lower.mesh);
        EXPECT_TRUE(sunk.intersect);
        EXPECT_TRUE(sunk.collide);
        EXPECT_LE(sunk.depth, 0.1 * gap + kRounding);
      }
    }
  }
}

/// A feature that is inside a face is as deep as it is far below it.
TEST(ProximityClosedForms, OfBoxesThatSinkIntoAFace)
{
  const TriangleMesh ground = translated(box({ 3.0, 3.0, 2.0 }), { 0.0, 0.0, -2.0 });
  for (const Tip& tip : tips())
  {
    for (const double depth : { 0.5, 1e-2, 1e-6 })
    {
      SCOPED_TRACE(std::string(tip.name) + ", " + std::to_string(depth));
      expectIntersecting(computeProximity(upsideDown(tip.mesh, -depth), ground), depth, kRounding);
    }
  }
}

TEST(ProximityClosedForms, OfABallInAShell)
{
  const TriangleMesh hollow = shell(1.0, 1.5, 4);
  const TriangleMesh ball = icosphere(0.4, 4);
  const double sag = 2.0 * sagOf(4);
  expectApart(computeProximity(ball, hollow), 0.6, sag);
  expectApart(computeProximity(translated(ball, { 0.5, 0.0, 0.0 }), hollow), 0.1, sag);
  expectIntersecting(computeProximity(translated(ball, { 0.7, 0.0, 0.0 }), hollow), 0.1, 2.0 * sag);
}

/// The surfaces of either are inside the other only half-way between faces.
TEST(ProximityClosedForms, OfCrossingSlabs)
{
  const TriangleMesh slab = box({ 2.0, 2.0, 0.1 });
  expectIntersecting(computeProximity(slab, turned(slab, 0, kPi / 2.0)), 0.1, kRounding);
  expectIntersecting(computeProximity(slab, translated(box({ 0.05, 0.7, 1.0 }), { 0.3, 0.4, 0.0 })),
    0.1, kRounding);
}

/// However small the part of their faces is that is inside, down to 1e-5 of the diagonal.
TEST(ProximityClosedForms, OfThinCrossingSlabs)
{
  for (const double half : { 1e-2, 1e-3, 1e-4, 1e-6 })
  {
    SCOPED_TRACE(half);
    const TriangleMesh slab = box({ 2.0, 2.0, half });
    const TriangleMesh post = box({ 0.5, 0.7 * half, 0.5 });
    const double tolerance = 1e-5 * post.bounds().diagonal();
    expectIntersecting(computeProximity(slab, turned(slab, 0, kPi / 2.0)), half, 4.0 * tolerance);
    expectIntersecting(computeProximity(slab, post), half, tolerance);
  }
}

TEST(ProximityClosedForms, OfParallelPlates)
{
  const TriangleMesh slab = box({ 1.0, 1.0, 0.125 });
  const TriangleMesh plate = makeMesh({ { -1, -1, 0 }, { 1, -1, 0 }, { 1, 1, 0 }, { -1, 1, 0 } },
    { { 0, 1, 2 }, { 0, 2, 3 } });
  for (const double gap : { 0x1p-40, 0x1p-10, 0.5, 8.0 })
  {
    SCOPED_TRACE(gap);
    expectApart(computeProximity(slab, translated(slab, { 0.25, -0.5, 0.25 + gap })), gap,
      kRounding);
    expectApart(computeProximity(plate, translated(plate, { 0.25, -0.5, gap })), gap, kRounding);
  }
}

/// Separation stays that of the surfaces.
TEST(ProximityClosedForms, OfNestedSolids)
{
  const TriangleMesh outer = box({ 2.0, 2.0, 2.0 });
  const TriangleMesh inner = translated(box({ 0.5, 0.25, 0.25 }), { 0.5, 0.0, 0.0 });
  const Proximity found = computeProximity(inner, outer);
  EXPECT_FALSE(found.intersect);
  EXPECT_TRUE(found.collide);
  EXPECT_NEAR(found.separation, 1.0, kRounding);
  EXPECT_LE(found.depth, 2.0 + kRounding); // in the middle of the face x = 0
  EXPECT_GE(found.depth, 2.0 * (1.0 - 1e-3));
  EXPECT_EQ(found.depthsOfA.size(), 8u);
  EXPECT_TRUE(found.depthsOfB.empty());
}

/// How deep surfaces are is not how far a box must move.
TEST(ProximityClosedForms, OfBoxesThatOverlapByThreeQuarters)
{
  const TriangleMesh cube = box({ 1.0, 1.0, 1.0 });
  expectIntersecting(computeProximity(cube, translated(cube, { 0.5, 0.0, 0.0 })), 0.5, kRounding);
}

/// Convex meshes: both bounds are the depth.
TEST(ProximityClosedForms, OfTheTranslationThatSeparatesBoxes)
{
  const TriangleMesh cube = box({ 1.0, 1.0, 1.0 });
  for (const Point3& offset : { Point3{ 0.5, 0.0, 0.0 }, Point3{ 0.25, -0.75, 0.5 },
         Point3{ 0.125, 0.25, 1.875 }, Point3{ 0.0, 0.0, 0.0 } })
  {
    const Proximity found = computeProximity(translated(cube, offset), cube);
    double depth = 2.0;
    for (const double x : offset)
    {
      depth = std::min(depth, 2.0 - std::abs(x));
    }
    EXPECT_NEAR(found.translationalDepth.lower, depth, 1e-8);
    EXPECT_NEAR(found.translationalDepth.upper, depth, 1e-8);
  }
}

} // namespace
} // namespace medial::test
