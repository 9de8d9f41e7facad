#include "failing_allocations.h"

#include "medial/proximity.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

// Frames need no memory beyond that of the frames before them.

namespace medial::test
{
namespace
{

/// Frames after which a motion begins again.
constexpr int kPeriod = 8;

/// A mesh that sways and bends, by frame.
std::vector<std::vector<Point3>> motionOf(const TriangleMesh& mesh, const Point3& offset)
{
  std::vector<std::vector<Point3>> frames;
  for (int frame = 0; frame < kPeriod; ++frame)
  {
    const double phase = 2.0 * std::acos(-1.0) * frame / kPeriod;
    frames.push_back(mesh.points);
    for (Point3& point : frames.back())
    {
      const double bend = 0.02 * std::sin(phase + point[2]);
      for (int axis = 0; axis < 3; ++axis)
      {
        point[axis] += offset[axis] * (1.0 + 0.1 * std::sin(phase)) + bend;
      }
    }
  }
  return frames;
}

void computeFrames(ProximitySolver& solver, const std::vector<std::vector<Point3>>& frames,
  int threads)
{
  ProximityOptions options;
  options.execution.threads = threads;
  for (const std::vector<Point3>& points : frames)
  {
    solver.setPoints(1, points);
    const Proximity& pair = solver.compute(options).front();
    EXPECT_TRUE(pair.collide);
    EXPECT_FALSE(pair.contacts.empty());
    EXPECT_GT(pair.translationalDepth.upper, 0.0);
  }
}

/// Allocations of all answers about two meshes that collide, once the motion has been seen.
std::int64_t allocationsOf(const TriangleMesh& a, const TriangleMesh& b, int threads)
{
  const std::vector<std::vector<Point3>> frames = motionOf(b, { 0.9, 0.3, 0.1 });
  ProximitySolver solver({ a, b });
  computeFrames(solver, frames, threads);
  computeFrames(solver, frames, threads);
  failAllocation(0, Failing::Once);
  computeFrames(solver, frames, threads);
  return stopFailing();
}

TEST(SteadyFrames, AllAnswersAboutCollidingMeshesAllocateNothing)
{
  const TriangleMesh ring = torus(1.0, 0.4, 24, 16);
  for (const int threads : { 1, 4 })
  {
    EXPECT_EQ(allocationsOf(ring, ring, threads), 0) << threads << " threads";
  }
}

TEST(SteadyFrames, AllAnswersAboutConvexMeshesAllocateNothing)
{
  EXPECT_EQ(allocationsOf(icosphere(1.0, 2), box({ 0.7, 0.7, 0.7 }), 2), 0);
}

} // namespace
} // namespace medial::test
