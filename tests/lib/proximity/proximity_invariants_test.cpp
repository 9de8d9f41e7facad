// What holds for the answer whatever the meshes are: soups, needles, other scales and places.
#include "medial/proximity.h"

#include "lib/proximity/proximity_checks.h"
#include "lib/proximity/proximity_oracle.h"
#include "support/brute_force.h"
#include "support/named.h"
#include "support/point_math.h"
#include "support/shapes.h"
#include "support/transforms.h"
#include "support/uneven_meshes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>
#include <vector>

namespace medial::test
{
namespace
{

/// Elements of any shape that enclose nothing for sure.
std::vector<Named<TriangleMesh>> soups()
{
  return { { "Soup", [] { return randomSoup(60, 3); } },
    { "ScatteredTriangles", [] { return scatteredTriangles(80, 1e-4, 1.0, 1.0); } },
    { "NeedleFan", [] { return needleFan(60, 2.0); } },
    { "TwistedStrip", [] { return twistedStrip(60, 2.0, 0.2); } },
    { "Plates", [] { return plates(0.1, 1.0); } } };
}

class ProximityOfSoups : public testing::TestWithParam<Named<TriangleMesh>>
{
protected:
  /// Without segments and points.
  TriangleMesh mesh_ = normalised(GetParam().make());
};

TEST_P(ProximityOfSoups, IsThatOfAllPairsOfTriangles)
{
  RandomMotions motions(11);
  const TriangleMesh ball = normalised(roughSphere(1.0, 2, 0.2));
  for (int i = 0; i < 40; ++i)
  {
    SCOPED_TRACE(i);
    const TriangleMesh a = snapped(moved(mesh_, motions.motion(2.0)));
    const TriangleMesh b =
      snapped(i % 2 == 0 ? moved(ball, motions.rotation()) : moved(mesh_, motions.rotation()));
    const Proximity found = computeProximity(a, b);
    const bool intersecting = surfacesIntersect(a, b);
    EXPECT_EQ(found.intersect, intersecting);
    EXPECT_GE(found.collide, intersecting);
    EXPECT_NEAR(found.separation, intersecting ? 0.0 : surfaceSeparation(a, b), 1e-12);
    EXPECT_EQ(found.separation == 0.0, intersecting);
    EXPECT_LE(distanceToCell(a, found.cellA, found.witnessA), 1e-12);
    EXPECT_LE(distanceToCell(b, found.cellB, found.witnessB), 1e-12);
    expectSame(mirrored(computeProximity(b, a)), found);
  }
}

INSTANTIATE_TEST_SUITE_P(Shapes, ProximityOfSoups, testing::ValuesIn(soups()), kNameOfParameter);

/// Poses of a mesh with corners and one without.
class ProximityInvariants : public testing::Test
{
protected:
  static constexpr int kPoses = 20;

  void next()
  {
    a_ = moved(partA_, motions_.motion(1.8));
    b_ = moved(partB_, motions_.rotation());
  }

  RandomMotions motions_{ 4 };
  TriangleMesh partA_ = normalised(lPrism(1.0, 0.5));
  TriangleMesh partB_ = normalised(roughSphere(1.0, 2, 0.3));
  TriangleMesh a_;
  TriangleMesh b_;
};

Proximity scaledProximity(Proximity found, double factor)
{
  for (double* value : { &found.separation, &found.depth, &found.depthAtMost,
         &found.translationalDepth.lower, &found.translationalDepth.upper })
  {
    *value *= factor;
  }
  const auto scalePoint = [&](Point3& point)
  {
    for (double& x : point)
    {
      x *= factor;
    }
  };
  scalePoint(found.witnessA);
  scalePoint(found.witnessB);
  scalePoint(found.deepestPoint);
  scalePoint(found.separatingTranslation);
  for (std::vector<PointDepth>* depths : { &found.depthsOfA, &found.depthsOfB })
  {
    for (PointDepth& depth : *depths)
    {
      depth.depth *= factor;
    }
  }
  for (ProximityContact& contact : found.contacts)
  {
    scalePoint(contact.point);
    contact.depth *= factor;
  }
  return found;
}

/// A power of two changes no rounding.
TEST_F(ProximityInvariants, ScalesWithTheMeshes)
{
  for (int i = 0; i < kPoses; ++i)
  {
    SCOPED_TRACE(i);
    this->next();
    const double factor = i % 2 == 0 ? 0x1p+30 : 0x1p-30;
    expectSame(computeProximity(scaled(a_, factor), scaled(b_, factor)),
      scaledProximity(computeProximity(a_, b_), factor));
  }
}

TEST_F(ProximityInvariants, StaysFarFromTheOrigin)
{
  for (int i = 0; i < kPoses; ++i)
  {
    SCOPED_TRACE(i);
    this->next();
    const Point3 offset{ 3e5, -2e6, 1e6 };
    const Proximity near = computeProximity(a_, b_);
    const Proximity far = computeProximity(translated(a_, offset), translated(b_, offset));
    EXPECT_EQ(far.collide, near.collide);
    EXPECT_NEAR(far.separation, near.separation, 1e-8);
    EXPECT_NEAR(far.depth, near.depth, 1e-8 + 1e-3 * near.depth);
    EXPECT_EQ(far.depthsOfA.size(), near.depthsOfA.size());
    EXPECT_EQ(far.depthsOfB.size(), near.depthsOfB.size());
  }
}

/// The same mesh with its triangles and points in the opposite order.
TriangleMesh reversed(const TriangleMesh& mesh)
{
  TriangleMesh result = mesh;
  const int last = static_cast<int>(mesh.points.size()) - 1;
  std::reverse(result.points.begin(), result.points.end());
  std::reverse(result.triangles.begin(), result.triangles.end());
  for (auto& triangle : result.triangles)
  {
    for (int& id : triangle)
    {
      id = last - id;
    }
  }
  return result;
}

TEST_F(ProximityInvariants, DoesNotDependOnTheOrderOfElements)
{
  for (int i = 0; i < kPoses; ++i)
  {
    SCOPED_TRACE(i);
    this->next();
    const Proximity expected = computeProximity(a_, b_);
    const Proximity found = computeProximity(reversed(a_), reversed(b_));
    EXPECT_EQ(found.intersect, expected.intersect);
    EXPECT_EQ(found.collide, expected.collide);
    EXPECT_NEAR(found.separation, expected.separation, 1e-15);
    EXPECT_NEAR(found.depth, expected.depth, 1e-3 * expected.depth);
    ASSERT_EQ(found.depthsOfB.size(), expected.depthsOfB.size());
    std::map<int, double> depths;
    for (const PointDepth& depth : expected.depthsOfB)
    {
      depths[static_cast<int>(b_.points.size()) - 1 - depth.point] = depth.depth;
    }
    for (const PointDepth& depth : found.depthsOfB)
    {
      EXPECT_NEAR(depth.depth, depths[depth.point], 1e-15);
    }
  }
}

/// Solvers whose options change give what fresh ones give.
TEST_F(ProximityInvariants, DoesNotDependOnWhatElseIsAskedFor)
{
  this->next();
  ProximitySolver solver({ a_, b_ });
  for (int i = 0; i < 2 * kPoses; ++i)
  {
    SCOPED_TRACE(i);
    this->next();
    solver.setPoints(0, a_.points);
    solver.setPoints(1, b_.points);
    ProximityOptions options;
    options.separation = i % 2 == 0;
    options.depths = i % 3 != 0;
    options.translationalDepth = i % 4 < 2;
    options.maxContacts = i % 5;
    const Proximity found = solver.compute(options).front();
    const Proximity all = computeProximity(a_, b_);
    EXPECT_EQ(found.intersect, all.intersect);
    EXPECT_EQ(found.collide, all.collide);
    if (all.intersect || options.separation)
    {
      EXPECT_NEAR(found.separation, all.separation, 1e-15);
    }
    EXPECT_EQ(std::isnan(found.separation), !all.intersect && !options.separation);
    EXPECT_EQ(std::isnan(found.depth), all.collide && !options.depths);
    if (options.depths)
    {
      EXPECT_NEAR(found.depth, all.depth, 1e-3 * all.depth);
      EXPECT_EQ(found.depthsOfA.size(), all.depthsOfA.size());
    }
    const bool bounded = !all.collide || (options.depths && options.translationalDepth);
    EXPECT_EQ(std::isinf(found.translationalDepth.upper), !bounded);
    EXPECT_EQ(found.contacts.empty(), !all.collide || !options.depths || options.maxContacts == 0);
  }
}

/// Nothing of an earlier frame is left.
TEST_F(ProximityInvariants, OfPairsThatAreLeftOutSaysNothing)
{
  ProximitySolver solver({ box({ 1, 1, 1 }), box({ 0.5, 0.7, 1.2 }) });
  EXPECT_TRUE(solver.compute().front().collide);
  solver.setPoints(1, translated(solver.mesh(1), { 5.0, 0.0, 0.0 }).points);
  ProximityOptions options;
  options.maxSeparation = 3.0;
  Proximity nothing;
  nothing.meshB = 1;
  nothing.separation = std::numeric_limits<double>::infinity();
  expectSame(solver.compute(options).front(), nothing);
}

/// A deformation that wears the trees out.
TEST_F(ProximityInvariants, OfBendingMeshesIsThatOfFreshSolvers)
{
  const TriangleMesh ring = torus(1.0, 0.3, 24, 12);
  const TriangleMesh ball = icosphere(0.5, 2);
  ProximitySolver solver({ ring, ball });
  for (int i = 0; i < kPoses; ++i)
  {
    SCOPED_TRACE(i);
    TriangleMesh bent = ring;
    for (Point3& p : bent.points)
    {
      p[2] += 0.4 * i * std::sin(2.0 * p[0]);
      p[0] *= 1.0 + 0.1 * i;
    }
    solver.setPoints(0, bent.points);
    const Proximity& found = solver.compute().front();
    const Proximity fresh = computeProximity(bent, ball);
    EXPECT_EQ(found.intersect, fresh.intersect);
    EXPECT_EQ(found.collide, fresh.collide);
    EXPECT_NEAR(found.separation, fresh.separation, 1e-15);
    EXPECT_NEAR(found.depth, fresh.depth, 1e-3 * fresh.depth);
    EXPECT_EQ(found.depthsOfA.size(), fresh.depthsOfA.size());
    EXPECT_EQ(found.depthsOfB.size(), fresh.depthsOfB.size());
  }
}

void expectSensible(const ProximityContact& contact, const TriangleMesh& a, const TriangleMesh& b)
{
  EXPECT_NEAR(length(contact.normal), 1.0, 1e-12);
  EXPECT_GE(contact.depth, 0.0);
  const double toA = closestOnMesh(a, contact.point).distance;
  const double toB = closestOnMesh(b, contact.point).distance;
  EXPECT_LT(std::min(toA, toB), 1e-9);
  EXPECT_LT(std::min(distanceToCell(a, contact.cellA, contact.point),
              distanceToCell(b, contact.cellB, contact.point)),
    1e-9);
}

TEST_F(ProximityInvariants, ContactsAreOnTheSurfacesAndInOrder)
{
  ProximityOptions options;
  options.maxContacts = 3;
  for (int i = 0; i < kPoses; ++i)
  {
    SCOPED_TRACE(i);
    this->next();
    const Proximity found = computeProximity(a_, b_, options);
    EXPECT_EQ(found.contacts.empty(), !found.collide);
    std::map<int, int> counts;
    for (std::size_t k = 0; k < found.contacts.size(); ++k)
    {
      const ProximityContact& contact = found.contacts[k];
      expectSensible(contact, a_, b_);
      EXPECT_LE(++counts[contact.manifold], options.maxContacts);
      if (k > 0)
      {
        const ProximityContact& last = found.contacts[k - 1];
        EXPECT_LE(last.manifold, contact.manifold);
        EXPECT_LE(contact.manifold, last.manifold + 1);
        EXPECT_TRUE(last.manifold != contact.manifold || last.depth >= contact.depth);
      }
      else
      {
        EXPECT_EQ(contact.manifold, 0);
      }
    }
  }
}

} // namespace
} // namespace medial::test
