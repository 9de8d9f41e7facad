// What ProximitySolver promises whatever the meshes are.
#include "medial/proximity.h"

#include "lib/proximity/proximity_checks.h"
#include "medial/error.h"
#include "support/errors.h"
#include "support/files.h"
#include "support/recorded_progress.h"
#include "support/resident_memory.h"
#include "support/shapes.h"
#include "support/transforms.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace medial::test
{
namespace
{

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

TriangleMesh cubeAt(double x)
{
  return translated(box({ 0.5, 0.5, 0.5 }), { x, 0.1, 0.2 });
}

TEST(ProximityContract, RefusesMeshesThatItCannotUse)
{
  const TriangleMesh cube = cubeAt(0.0);
  expectError([&] { ProximitySolver solver({ cube }); }, ErrorCode::InvalidInput, "1");
  expectError([&] { ProximitySolver solver({ cube, {} }); }, ErrorCode::InvalidInput, "1");
  expectError([&] { computeProximity({}, cube); }, ErrorCode::InvalidInput, "0");
}

TEST(ProximityContract, NamesTheMeshThatItCannotUse)
{
  const TriangleMesh cube = cubeAt(0.0);
  TriangleMesh wrong = cube;
  wrong.triangles[3][1] = 99;
  expectError([&] { computeProximity(cube, wrong); }, ErrorCode::InvalidInput, "mesh 1");
}

TEST(ProximityContract, RefusesMeshesWithCoordinatesThatAreNotFinite)
{
  const TriangleMesh cube = cubeAt(0.0);
  for (const double bad : { kNan, std::numeric_limits<double>::infinity(), 1e19 })
  {
    TriangleMesh wrong = cube;
    wrong.points[4][2] = bad;
    expectError([&] { computeProximity(cube, wrong); }, ErrorCode::InvalidInput, "mesh 1");
  }
}

TEST(ProximityContract, RefusesPointsThatItCannotUseAndKeepsTheOthers)
{
  ProximitySolver solver({ cubeAt(0.0), cubeAt(0.75) });
  const Proximity before = solver.compute().front();
  std::vector<Point3> points = solver.mesh(1).points;
  points.pop_back();
  expectError([&] { solver.setPoints(1, points); }, ErrorCode::InvalidInput);
  for (const int index : { -1, 2 })
  {
    expectError([&] { solver.setPoints(index, solver.mesh(0).points); }, ErrorCode::InvalidInput);
  }
  for (const double bad : { kNan, -std::numeric_limits<double>::infinity(), 1.1e18 })
  {
    points = solver.mesh(1).points;
    points[0] = { 9.0, 9.0, 9.0 };
    points[7][1] = bad;
    expectError([&] { solver.setPoints(1, points); }, ErrorCode::InvalidInput);
  }
  EXPECT_EQ(solver.mesh(1).points, cubeAt(0.75).points);
  expectSame(solver.compute().front(), before);
}

TEST(ProximityContract, RefusesOptionsOutsideTheirRanges)
{
  const auto compute = [](const ProximityOptions& options)
  { computeProximity(cubeAt(0.0), cubeAt(0.5), options); };
  ProximityOptions options;
  options.maxContacts = -1;
  expectError([&] { compute(options); }, ErrorCode::InvalidInput, "-1");
  options.maxContacts = 0;
  compute(options);
  for (const double tolerance : { 0.0, -1e-3, 1.0, 2.0, kNan })
  {
    options.depthTolerance = tolerance;
    expectError([&] { compute(options); }, ErrorCode::InvalidInput);
  }
  for (const double tolerance : { 1e-9, 0.999 })
  {
    options.depthTolerance = tolerance;
    compute(options);
  }
}

TEST(ProximityContract, ComputesNoMoreThanIsAskedFor)
{
  const TriangleMesh corner = translated(box({ 0.5, 0.5, 0.5 }), { 0.75, 0.7, 0.6 });
  const auto compute = [&](const ProximityOptions& options)
  { return computeProximity(cubeAt(0.0), corner, options); };
  ProximityOptions options;
  const Proximity all = compute(options);
  EXPECT_GT(all.depth, 0.0);
  EXPECT_FALSE(all.contacts.empty());
  EXPECT_EQ(all.depthsOfA.size(), 1u);
  EXPECT_EQ(all.depthsOfB.size(), 1u);
  options.maxContacts = 0;
  EXPECT_TRUE(compute(options).contacts.empty());
  EXPECT_EQ(compute(options).depth, all.depth);
  options.depths = false;
  options.translationalDepth = false;
  const Proximity least = compute(options);
  EXPECT_TRUE(least.intersect);
  EXPECT_TRUE(least.collide);
  EXPECT_EQ(least.separation, 0.0);
  EXPECT_TRUE(std::isnan(least.depth));
  EXPECT_TRUE(least.depthsOfA.empty());
  EXPECT_TRUE(least.depthsOfB.empty());
}

/// Nested solids collide though nothing intersects.
TEST(ProximityContract, CollidesWithoutDepthsToo)
{
  ProximityOptions options;
  options.depths = false;
  const TriangleMesh outer = box({ 2.0, 2.0, 2.0 });
  for (const bool swapped : { false, true })
  {
    const Proximity found = swapped ? computeProximity(outer, cubeAt(0.0), options)
                                    : computeProximity(cubeAt(0.0), outer, options);
    EXPECT_FALSE(found.intersect);
    EXPECT_TRUE(found.collide);
    EXPECT_GT(found.separation, 1.0);
  }
}

TEST(ProximityContract, OfManyMeshesIsThatOfEveryPair)
{
  const std::vector<TriangleMesh> meshes{ cubeAt(0.0), translated(icosphere(0.5, 2), { 0.7, 0, 0 }),
    box({ 2.0, 2.0, 2.0 }), makeMesh({ { 0, 0, 0 }, { 0.1, 3, 0 } }, {}, { { 0, 1 } }) };
  ProximitySolver solver(meshes);
  EXPECT_EQ(solver.meshCount(), 4);
  const std::vector<Proximity>& found = solver.compute();
  ASSERT_EQ(found.size(), 6u);
  std::size_t next = 0;
  for (int a = 0; a < 4; ++a)
  {
    for (int b = a + 1; b < 4; ++b)
    {
      const Proximity& pair = found[next++];
      EXPECT_EQ(pair.meshA, a);
      EXPECT_EQ(pair.meshB, b);
      expectSame(pair, computeProximity(meshes[a], meshes[b]));
    }
  }
}

TEST(ProximityContract, MovesOnlyWhatIsMoved)
{
  ProximitySolver solver({ cubeAt(0.0), cubeAt(2.0), cubeAt(9.0) });
  solver.compute();
  solver.setPoints(2, cubeAt(3.5).points);
  const std::vector<Proximity>& found = solver.compute();
  EXPECT_NEAR(found[0].separation, 1.0, 1e-12);
  EXPECT_NEAR(found[1].separation, 2.5, 1e-12);
  EXPECT_NEAR(found[2].separation, 0.5, 1e-12);
}

TEST(ProximityContract, MovedSolversGoOn)
{
  ProximitySolver solver({ cubeAt(0.0), cubeAt(2.0) });
  solver.compute();
  ProximitySolver next(std::move(solver));
  EXPECT_NEAR(next.compute().front().separation, 1.0, 1e-12);
  solver = std::move(next);
  solver.setPoints(1, cubeAt(3.0).points);
  EXPECT_NEAR(solver.compute().front().separation, 2.0, 1e-12);
}

/// Cancels when it is asked after so many times.
class Canceller : public RecordedProgress
{
public:
  explicit Canceller(int calls)
    : calls_(calls)
  {
  }

  bool cancelled() override { return --calls_ < 0; }

private:
  int calls_;
};

TEST(ProximityContract, EndsWhenCancelledAndGoesOnAfterwards)
{
  ProximitySolver solver({ cubeAt(0.0), cubeAt(0.75), cubeAt(3.0) });
  Canceller canceller(1);
  ProximityOptions options;
  options.execution.progress = &canceller;
  expectError([&] { solver.compute(options); }, ErrorCode::Cancelled);
  expectSame(solver.compute().front(), computeProximity(cubeAt(0.0), cubeAt(0.75)));
  Canceller patient(1000000);
  options.execution.progress = &patient;
  solver.compute(options);
  EXPECT_EQ(patient.last(), 1.0);
}

/// Bodies that pass through each other over and over.
TEST(ProximityContract, KeepsItsSizeOverManyFrames)
{
  const TriangleMesh ball = icosphere(0.5, 2);
  const TriangleMesh ring = torus(1.0, 0.3, 20, 10);
  ProximitySolver solver({ ball, ring, cubeAt(0.0) });
  RandomMotions motions(1);
  int frame = 0;
  const auto compute = [&](int frames)
  {
    for (int i = 0; i < frames; ++i, ++frame)
    {
      const double angle = 0.17 * frame;
      const RigidMotion turn = motions.rotation();
      solver.setPoints(0,
        translated(moved(ball, turn), { std::sin(angle), std::cos(3.0 * angle), 0.3 }).points);
      solver.compute();
    }
  };
  compute(50);
  const double before = residentMiB();
  compute(250);
  EXPECT_LT(residentMiB() - before, kAllowedGrowth);
}

} // namespace
} // namespace medial::test
