#include "medial/proximity.h"

#include "support/point_math.h"
#include "support/shapes.h"
#include "support/transforms.h"

#include <gtest/gtest.h>

#include <cmath>

namespace
{

using medial::computeProximity;
using medial::Point3;
using medial::Proximity;
using medial::TriangleMesh;
using medial::test::box;
using medial::test::length;
using medial::test::translated;

/// Whether the translation of a result separates the meshes, and the bounds are in order.
void expectSeparating(const TriangleMesh& a, const TriangleMesh& b, const Proximity& result)
{
  EXPECT_LE(result.translationalDepth.lower, result.translationalDepth.upper);
  EXPECT_NEAR(length(result.separatingTranslation), result.translationalDepth.upper,
    1e-12 * length({ 1, 1, 1 }));
  EXPECT_FALSE(computeProximity(translated(a, result.separatingTranslation), b).collide);
}

TEST(TranslationalDepth, OfBoxesIsTheLeastOverlapAlongAnAxis)
{
  const TriangleMesh a = box({ 1.0, 1.0, 1.0 });
  for (const Point3& shift : { Point3{ 0.5, 0.0, 0.0 }, Point3{ 1.5, 0.25, 0.5 },
         Point3{ 0.125, 0.0, -1.75 }, Point3{ 0.0, 0.0, 0.0 } })
  {
    const TriangleMesh b = translated(a, shift);
    const Proximity result = computeProximity(a, b);
    const double largest = std::max({ std::abs(shift[0]), std::abs(shift[1]), std::abs(shift[2]) });
    EXPECT_NEAR(result.translationalDepth.lower, 2.0 - largest, 1e-7);
    EXPECT_NEAR(result.translationalDepth.upper, 2.0 - largest, 1e-7);
    expectSeparating(a, b, result);
  }
}

TEST(TranslationalDepth, OfBoxesThatOverlapIsNotTheirDepth)
{
  const TriangleMesh a = box({ 1.0, 1.0, 1.0 });
  const Proximity result = computeProximity(a, translated(a, { 0.5, 0.0, 0.0 }));
  EXPECT_NEAR(result.translationalDepth.upper, 1.5, 1e-7);
  EXPECT_NEAR(result.depth, 0.5, 1e-3);
}

TEST(TranslationalDepth, OfBallsIsTheSumOfRadiiLessTheDistance)
{
  const TriangleMesh ball = medial::test::icosphere(1.0, 4);
  const TriangleMesh other = translated(ball, { 0.5, -0.6, 0.7 });
  const Proximity result = computeProximity(ball, other);
  const double expected = 2.0 - length({ 0.5, -0.6, 0.7 });
  EXPECT_NEAR(result.translationalDepth.lower, expected, 5e-3);
  EXPECT_NEAR(result.translationalDepth.upper, expected, 5e-3);
  // Both are convex.
  EXPECT_NEAR(result.translationalDepth.lower, result.translationalDepth.upper, 1e-6);
  expectSeparating(ball, other, result);
}

TEST(TranslationalDepth, OfAPegInAnLIsItsWayOut)
{
  // The hulls overlap much more than the solids.
  const TriangleMesh l = medial::test::lPrism(1.0, 1.0);
  const TriangleMesh peg = translated(box({ 0.3, 0.3, 0.3 }), { 0.25, 0.25, 0.0 });
  const Proximity result = computeProximity(l, peg);
  ASSERT_TRUE(result.collide);
  EXPECT_NEAR(result.translationalDepth.upper, 0.05 * std::sqrt(2.0), 1e-6);
  EXPECT_GE(result.translationalDepth.lower, 0.02);
  expectSeparating(l, peg, result);
}

TEST(TranslationalDepth, IsNothingWhereMeshesAreApart)
{
  const TriangleMesh a = box({ 1.0, 1.0, 1.0 });
  const Proximity result = computeProximity(a, translated(a, { 3.0, 0.0, 0.0 }));
  EXPECT_EQ(result.translationalDepth.lower, 0.0);
  EXPECT_EQ(result.translationalDepth.upper, 0.0);
}

TEST(TranslationalDepth, OfAMeshInsideAnotherLeadsOutOfIt)
{
  const TriangleMesh outer = box({ 1.0, 1.0, 1.0 });
  const TriangleMesh inner = translated(box({ 0.1, 0.1, 0.1 }), { 0.5, 0.0, 0.0 });
  const Proximity result = computeProximity(inner, outer);
  EXPECT_TRUE(result.collide);
  EXPECT_FALSE(result.intersect);
  EXPECT_NEAR(result.separation, 0.4, 1e-12);
  EXPECT_NEAR(result.translationalDepth.upper, 0.6, 1e-7);
  EXPECT_NEAR(result.translationalDepth.lower, 0.6, 1e-7);
  expectSeparating(inner, outer, result);
}

} // namespace
