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

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <iostream>
#include <iterator>
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
  double sizeOfB = 1.0; ///< its diagonal, as a part of that of A
  int poses = 40;
};

std::vector<Named<MeshPair>> generatedPairs()
{
  const auto named = [](const char* name, const std::function<MeshPair()>& make) {
    return Named<MeshPair>{ name, make };
  };
  return { named("Convex",
             []
             {
               return MeshPair{ ellipsoid(1.0, 0.7, 0.5, 2), subdivided(box({ 1.0, 0.6, 0.3 }), 1),
                 2.0, true };
             }),
    named("ConvexInConvex",
      [] {
        return MeshPair{ icosphere(1.0, 2), regularTetrahedron(1.0), 1.1, true, 0.4 };
      }),
    named("Parts",
      [] {
        return MeshPair{ lPrism(1.0, 0.5), blocks({ "###", "#.#", "#.." }, 0.4), 1.8 };
      }),
    named("WedgeInRing",
      [] {
        return MeshPair{ torus(1.0, 0.3, 24, 12), wedge(300.0, 1.0, 1.0), 1.6, false, 0.7 };
      }),
    named("Organic",
      [] {
        return MeshPair{ roughSphere(1.0, 2, 0.3), roughSphere(1.0, 2, 0.15), 1.5, false, 0.5 };
      }),
    named("InHollow",
      [] {
        return MeshPair{ shell(0.7, 1.0, 2), lPrism(1.0, 0.5), 1.0, false, 0.3 };
      }) };
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
         ModelPair{ "JointAndGears", "cad/joint_446.off", "cad/gears_7comp_19k.stl", 2.2 } })
  {
    const auto a = modelPath(pair.a);
    const auto b = modelPath(pair.b);
    if (a && b)
    {
      pairs.push_back({ pair.name, [=] {
                         return MeshPair{ loadMesh(*a), loadMesh(*b), pair.reach, false, 1.0, 6 };
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
    pair_.b = scaled(normalised(pair_.b), pair_.sizeOfB);
  }

  /// For what is compared without the oracle.
  int fewPoses() const { return std::max(2, pair_.poses / 4); }
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
    const ProximityChecks checks{ pair_.convex, i % 10 == 0 };
    const ProximityErrors ofPose = errorsOf(a, b, computeProximity(a, b), checks);
    SCOPED_TRACE(i);
    expectRight(ofPose);
    errors.add(ofPose);
  }
  std::cout << errors.describe() << '\n';
  EXPECT_GT(errors.intersecting, count / 6);
  EXPECT_LT(errors.intersecting, count * 5 / 6);
}

/// Poses of the oracle's resolution, 2^-38, from touching.
TEST_P(ProximityOfPoses, IsThatOfTheOracleWhereSurfacesNearlyTouch)
{
  for (int i = 0; i < 2 * this->fewPoses(); ++i)
  {
    SCOPED_TRACE(i);
    const TriangleMesh a = this->nextA();
    const TriangleMesh b = this->nextB();
    const Proximity apart = computeProximity(a, b);
    if (apart.intersect)
    {
      continue;
    }
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
  for (int i = 0; i < this->fewPoses(); ++i)
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
  for (int i = 0; i < this->fewPoses(); ++i)
  {
    SCOPED_TRACE(i);
    const TriangleMesh a = this->nextA();
    const TriangleMesh b = this->nextB();
    expectSame(computeProximity(a, b, one), computeProximity(a, b, two));
  }
}

void expectNear(const std::vector<PointDepth>& a, const std::vector<PointDepth>& b,
  double tolerance)
{
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i)
  {
    EXPECT_EQ(a[i].point, b[i].point);
    EXPECT_NEAR(a[i].depth, b[i].depth, tolerance);
  }
}

/// The depth is searched for up to its tolerance, and bounds of meshes that are not convex have
/// room between them.
void expectNear(const Proximity& a, const Proximity& b, double tolerance, bool convex)
{
  EXPECT_EQ(a.intersect, b.intersect);
  EXPECT_EQ(a.collide, b.collide);
  EXPECT_EQ(a.insideUndefined, b.insideUndefined);
  EXPECT_NEAR(a.separation, b.separation, tolerance);
  EXPECT_NEAR(a.depth, b.depth,
    tolerance + ProximityOptions().depthTolerance * std::max(a.depth, b.depth));
  expectNear(a.depthsOfA, b.depthsOfA, tolerance);
  expectNear(a.depthsOfB, b.depthsOfB, tolerance);
  const double room = convex ? tolerance : 0.05;
  EXPECT_NEAR(a.translationalDepth.lower, b.translationalDepth.lower, room);
  EXPECT_NEAR(a.translationalDepth.upper, b.translationalDepth.upper, room);
  EXPECT_LE(a.translationalDepth.lower, b.translationalDepth.upper);
  EXPECT_LE(b.translationalDepth.lower, a.translationalDepth.upper);
}

TEST_P(ProximityOfPoses, StaysInACommonRigidMotion)
{
  for (int i = 0; i < this->fewPoses(); ++i)
  {
    SCOPED_TRACE(i);
    const TriangleMesh a = this->nextA();
    const TriangleMesh b = this->nextB();
    const RigidMotion motion = motions_.motion(10.0);
    expectNear(computeProximity(a, b), computeProximity(moved(a, motion), moved(b, motion)), 1e-6,
      pair_.convex);
  }
}

TEST_P(ProximityOfPoses, OfFramesIsThatOfFreshSolvers)
{
  ProximitySolver solver({ this->nextA(), this->nextB() });
  for (int i = 0; i < this->fewPoses(); ++i)
  {
    SCOPED_TRACE(i);
    const TriangleMesh a = i % 3 == 2 ? solver.mesh(0) : this->nextA();
    const TriangleMesh b = i % 2 == 0 ? solver.mesh(1) : this->nextB();
    solver.setPoints(0, a.points);
    solver.setPoints(1, b.points);
    const Proximity& found = solver.compute().front();
    expectNear(found, computeProximity(a, b), 1e-12, pair_.convex);
  }
}

/// A ball without its top.
TriangleMesh openBall()
{
  TriangleMesh mesh = icosphere(1.0, 2);
  const auto isTop = [&](const std::array<int, 3>& t)
  { return std::all_of(t.begin(), t.end(), [&](int id) { return mesh.points[id][2] > 0.6; }); };
  std::vector<std::array<int, 3>> triangles;
  std::remove_copy_if(mesh.triangles.begin(), mesh.triangles.end(), std::back_inserter(triangles),
    isTop);
  return makeMesh(mesh.points, triangles);
}

/// What winding numbers say of the points of a mesh and an open one.
struct OpenInside
{
  std::vector<int> inside;
  bool undefined = false;
  bool unclear = false; ///< a winding number is near a limit
};

OpenInside pointsInside(const TriangleMesh& mesh, const TriangleMesh& open)
{
  const Bounds bounds = open.bounds();
  OpenInside result;
  for (std::size_t i = 0; i < mesh.points.size(); ++i)
  {
    const Point3& p = mesh.points[i];
    bool near = true;
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      near = near && bounds.min[axis] <= p[axis] && p[axis] <= bounds.max[axis];
    }
    const double number = near ? windingNumber(open, p) : 0.0;
    constexpr double kMargin = 2e-3;
    result.unclear =
      result.unclear || std::abs(number - 0.25) < kMargin || std::abs(number - 0.75) < kMargin;
    result.undefined = result.undefined || (number > 0.25 && number < 0.75);
    if (number >= 0.75)
    {
      result.inside.push_back(static_cast<int>(i));
    }
  }
  return result;
}

std::vector<int> idsOf(const std::vector<PointDepth>& depths)
{
  std::vector<int> ids;
  for (const PointDepth& depth : depths)
  {
    ids.push_back(depth.point);
  }
  return ids;
}

TEST(ProximityOfOpenMeshes, IsWhatWindingNumbersSay)
{
  const TriangleMesh open = normalised(openBall());
  const TriangleMesh closed = scaled(normalised(ellipsoid(1.0, 0.3, 0.3, 2)), 0.6);
  RandomMotions motions(5);
  int undefined = 0;
  int contained = 0;
  const int count = poseCount(100);
  for (int i = 0; i < count; ++i)
  {
    SCOPED_TRACE(i);
    const TriangleMesh a = snapped(moved(closed, motions.motion(1.0)));
    const TriangleMesh b = snapped(moved(open, motions.rotation()));
    const OpenInside expected = pointsInside(a, b);
    const Proximity found = computeProximity(a, b);
    EXPECT_EQ(found.intersect, surfacesIntersect(a, b));
    if (expected.unclear)
    {
      continue;
    }
    EXPECT_EQ(found.insideUndefined, expected.undefined);
    EXPECT_EQ(std::isnan(found.depth), expected.undefined);
    undefined += expected.undefined ? 1 : 0;
    if (!expected.undefined)
    {
      EXPECT_EQ(found.collide, found.intersect || !expected.inside.empty());
      EXPECT_EQ(idsOf(found.depthsOfA), expected.inside);
      contained += found.collide && !found.intersect ? 1 : 0;
    }
  }
  EXPECT_GT(undefined, 10);
  EXPECT_GT(contained, 2);
}

INSTANTIATE_TEST_SUITE_P(Shapes, ProximityOfPoses, testing::ValuesIn(generatedPairs()),
  kNameOfParameter);
GTEST_ALLOW_UNINSTANTIATED_PARAMETERIZED_TEST(ProximityOfPoses);
INSTANTIATE_TEST_SUITE_P(Models, ProximityOfPoses, testing::ValuesIn(modelPairs()),
  kNameOfParameter);

} // namespace
} // namespace medial::test
