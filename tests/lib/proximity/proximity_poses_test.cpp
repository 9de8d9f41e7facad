// Pairs of meshes in random poses against the oracle, and how they are computed against each other.
#include "medial/proximity.h"

#include "lib/proximity/proximity_checks.h"
#include "lib/proximity/proximity_oracle.h"
#include "support/brute_force.h"
#include "support/model_formats.h"
#include "support/models.h"
#include "support/named.h"
#include "support/shapes.h"
#include "support/transforms.h"
#include "support/uneven_meshes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <iostream>
#include <string>
#include <utility>
#include <vector>

namespace medial::test
{
namespace
{

/// Two meshes and how far apart they may be posed, so that about half of the poses intersect.
struct MeshPair
{
  TriangleMesh a;
  TriangleMesh b;
  double reach;
  bool convex = false;
  int poses = 40;
};

std::vector<Named<MeshPair>> generatedPairs()
{
  return {
    { "Convex",
      []
      {
        return MeshPair{ ellipsoid(1.0, 0.7, 0.5, 2), subdivided(box({ 1.0, 0.6, 0.3 }), 1), 2.0,
          true };
      } },
    { "Balls",
      [] {
        return MeshPair{ icosphere(1.0, 2), icosphere(1.0, 1), 2.0, true };
      } },
    { "Parts",
      [] {
        return MeshPair{ lPrism(1.0, 0.5), blocks({ "###", "#.#", "#.." }, 0.4), 1.8 };
      } },
    { "WedgeInRing",
      [] {
        return MeshPair{ wedge(300.0, 1.0, 1.0), torus(1.0, 0.3, 24, 12), 1.6 };
      } },
    { "Organic",
      [] {
        return MeshPair{ roughSphere(1.0, 2, 0.3), roughSphere(1.0, 2, 0.15), 2.1 };
      } },
    { "Hollow",
      [] {
        return MeshPair{ shell(0.7, 1.0, 2), scaled(regularTetrahedron(1.0), 1.0), 1.9 };
      } },
  };
}

struct ModelPair
{
  const char* name;
  const char* a;
  const char* b;
  double reach;
};

/// Those that are there.
std::vector<Named<MeshPair>> modelPairs()
{
  std::vector<Named<MeshPair>> pairs;
  for (const ModelPair& pair : { ModelPair{ "BunnyAndGargoyle", "paper/derived/bunny_1500.off",
                                   "paper/derived/gargoyle_11000.off", 1.4 },
         ModelPair{ "JointAndGears", "cad/joint_446.off", "cad/gears_7comp_19k.stl", 1.2 } })
  {
    const auto a = modelPath(pair.a);
    const auto b = modelPath(pair.b);
    if (a && b)
    {
      pairs.push_back({ pair.name, [=] {
                         return MeshPair{ loadMesh(*a), loadMesh(*b), pair.reach, false, 4 };
                       } });
    }
  }
  return pairs;
}

/// How many poses the environment variable MEDIAL_PROXIMITY_POSES asks for, or else `usual`.
int poseCount(int usual)
{
  const char* text = std::getenv("MEDIAL_PROXIMITY_POSES");
  return text != nullptr ? std::atoi(text) : usual;
}

class ProximityOfPoses : public testing::TestWithParam<Named<MeshPair>>
{
protected:
  ProximityOfPoses()
    : pair_(GetParam().make())
    , motions_(static_cast<std::uint32_t>(GetParam().name.size()))
  {
    pair_.a = normalised(pair_.a);
    pair_.b = normalised(pair_.b);
  }

  TriangleMesh nextA() { return snapped(moved(pair_.a, motions_.motion(pair_.reach))); }
  TriangleMesh nextB() { return snapped(moved(pair_.b, motions_.rotation())); }

  MeshPair pair_;
  RandomMotions motions_;
};

TEST_P(ProximityOfPoses, IsThatOfTheOracle)
{
  const int count = poseCount(pair_.poses);
  ProximityErrors errors;
  for (int i = 0; i < count; ++i)
  {
    const TriangleMesh a = this->nextA();
    const TriangleMesh b = this->nextB();
    const ProximityChecks checks{ pair_.convex, i % 8 == 0 ? 5 : 0 };
    const ProximityErrors ofPose = errorsOf(a, b, computeProximity(a, b), checks);
    SCOPED_TRACE(i);
    expectRight(ofPose);
    errors.add(ofPose);
  }
  std::cout << errors.describe() << '\n';
  EXPECT_GT(errors.intersecting, count / 5);
  EXPECT_LT(errors.intersecting, count * 4 / 5);
}

/// Poses of the oracle's resolution, 2^-38, from touching.
TEST_P(ProximityOfPoses, IsThatOfTheOracleWhereSurfacesNearlyTouch)
{
  const int count = std::max(8, pair_.poses / 4);
  for (int i = 0; i < count;)
  {
    const TriangleMesh a = this->nextA();
    const TriangleMesh b = this->nextB();
    const Proximity apart = computeProximity(a, b);
    if (apart.intersect)
    {
      continue;
    }
    ++i;
    SCOPED_TRACE(i);
    const double factor = 1.0 + (i % 5 - 2) * 1e-12;
    Point3 step;
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      step[axis] = factor * (apart.witnessB[axis] - apart.witnessA[axis]);
    }
    const TriangleMesh touching = snapped(translated(a, step));
    const Proximity found = computeProximity(touching, b);
    EXPECT_EQ(found.intersect, surfacesIntersect(touching, b));
    EXPECT_EQ(found.intersect, found.separation == 0.0);
    EXPECT_EQ(found.collide, found.intersect || apart.collide);
    EXPECT_LT(found.separation, 1e-10);
  }
}

TEST_P(ProximityOfPoses, IsMirroredIfTheMeshesAreSwapped)
{
  for (int i = 0; i < std::max(4, pair_.poses / 4); ++i)
  {
    SCOPED_TRACE(i);
    const TriangleMesh a = this->nextA();
    const TriangleMesh b = this->nextB();
    expectSame(mirrored(computeProximity(b, a)), computeProximity(a, b));
  }
}

TEST_P(ProximityOfPoses, IsTheSameForAnyNumberOfThreads)
{
  ProximityOptions one;
  one.execution.threads = 1;
  ProximityOptions two;
  two.execution.threads = 2;
  for (int i = 0; i < std::max(4, pair_.poses / 4); ++i)
  {
    SCOPED_TRACE(i);
    const TriangleMesh a = this->nextA();
    const TriangleMesh b = this->nextB();
    expectSame(computeProximity(a, b, one), computeProximity(a, b, two));
  }
}

/// Scalars agree up to rounding; depths that are searched for only up to their tolerance.
void expectEqualUpToRounding(const Proximity& a, const Proximity& b, double tolerance)
{
  EXPECT_EQ(a.intersect, b.intersect);
  EXPECT_EQ(a.collide, b.collide);
  EXPECT_EQ(a.insideUndefined, b.insideUndefined);
  EXPECT_NEAR(a.separation, b.separation, tolerance);
  EXPECT_NEAR(a.depth, b.depth, tolerance + 1e-3 * std::max(a.depth, b.depth));
  EXPECT_NEAR(a.translationalDepth.lower, b.translationalDepth.lower, tolerance);
  EXPECT_NEAR(a.translationalDepth.upper, b.translationalDepth.upper, tolerance);
  for (const auto depths : { &Proximity::depthsOfA, &Proximity::depthsOfB })
  {
    ASSERT_EQ((a.*depths).size(), (b.*depths).size());
    for (std::size_t i = 0; i < (a.*depths).size(); ++i)
    {
      EXPECT_EQ((a.*depths)[i].point, (b.*depths)[i].point);
      EXPECT_NEAR((a.*depths)[i].depth, (b.*depths)[i].depth, tolerance);
    }
  }
}

TEST_P(ProximityOfPoses, StaysInACommonRigidMotion)
{
  for (int i = 0; i < std::max(4, pair_.poses / 4); ++i)
  {
    SCOPED_TRACE(i);
    const TriangleMesh a = this->nextA();
    const TriangleMesh b = this->nextB();
    RigidMotion motion = motions_.motion(10.0);
    expectEqualUpToRounding(computeProximity(a, b),
      computeProximity(moved(a, motion), moved(b, motion)), 1e-6);
  }
}

TEST_P(ProximityOfPoses, OfFramesIsThatOfFreshSolvers)
{
  ProximitySolver solver({ this->nextA(), this->nextB() });
  for (int i = 0; i < std::max(6, pair_.poses / 4); ++i)
  {
    SCOPED_TRACE(i);
    const TriangleMesh a = i % 3 == 2 ? solver.mesh(0) : this->nextA();
    const TriangleMesh b = i % 2 == 0 ? solver.mesh(1) : this->nextB();
    solver.setPoints(0, a.points);
    solver.setPoints(1, b.points);
    const Proximity& found = solver.compute().front();
    expectEqualUpToRounding(found, computeProximity(a, b), 1e-12);
  }
}

INSTANTIATE_TEST_SUITE_P(Shapes, ProximityOfPoses, testing::ValuesIn(generatedPairs()),
  kNameOfParameter);
GTEST_ALLOW_UNINSTANTIATED_PARAMETERIZED_TEST(ProximityOfPoses);
INSTANTIATE_TEST_SUITE_P(Models, ProximityOfPoses, testing::ValuesIn(modelPairs()),
  kNameOfParameter);

} // namespace
} // namespace medial::test
