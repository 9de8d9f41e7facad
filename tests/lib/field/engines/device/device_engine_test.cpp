// What only the engine `device` promises: few bytes, no leaks, checks of itself.
#include "device_runs.h"
#include "gl/fault.h"
#include "gl/gpu_thread.h"
#include "medial/compute_distance_field.h"
#include "medial/error.h"
#include "medial/medial_solver.h"
#include "support/errors.h"
#include "support/recorded_progress.h"
#include "support/resident_memory.h"

#include <epoxy/gl.h>
#include <gtest/gtest.h>

#include <ostream>
#include <thread>
#include <vector>

namespace medial::test
{
namespace
{

TEST(DeviceEngine, MovesFewBytes)
{
  const TriangleMesh mesh = ring();
  const auto vertices = static_cast<std::int64_t>(mesh.points.size());
  MedialSolver solver(mesh);
  DistanceFieldOptions options;
  options.engine = Engine::Device;
  const Grid grid = makeGrid(mesh.bounds(), 24, 0.1);
  std::vector<float> distance(grid.pointCount());
  std::vector<std::int32_t> sites(grid.pointCount());
  FieldArrays arrays;
  arrays.distance = distance.data();
  arrays.closestSite = sites.data();
  const RunStatistics first = solver.computeField(grid, grid.wholeExtent(), arrays, options);
  gl::injectFault(gl::Fault::AllocationRefused); // none is needed any more
  const RunStatistics second = solver.computeField(grid, grid.wholeExtent(), arrays, options);
  gl::injectFault(gl::Fault::None);
  EXPECT_GT(first.bytesUploaded, second.bytesUploaded);
  EXPECT_LE(second.bytesUploaded, 12 * vertices + 4096);
  EXPECT_LE(second.bytesReadBack, 8 * grid.pointCount() + 65536);
  EXPECT_EQ(second.dispatches, first.dispatches);
}

/// What the GPU thread's context has.
struct DeviceObjects
{
  int buffers = 0, textures = 0, queries = 0, programs = 0;
  std::int64_t bytes = 0; ///< of the buffers
};

bool operator==(const DeviceObjects& a, const DeviceObjects& b)
{
  return a.buffers == b.buffers && a.textures == b.textures && a.queries == b.queries &&
    a.programs == b.programs && a.bytes == b.bytes;
}

std::ostream& operator<<(std::ostream& out, const DeviceObjects& objects)
{
  return out << objects.buffers << " buffers of " << objects.bytes << " bytes, " << objects.textures
             << " textures, " << objects.queries << " queries, " << objects.programs << " programs";
}

/// Asks for every name, since drivers give them out in order.
DeviceObjects deviceObjects()
{
  constexpr GLuint kNames = 20000;
  DeviceObjects found;
  gl::GpuThread::instance().run(
    [&]
    {
      for (GLuint name = 1; name <= kNames; ++name)
      {
        found.textures += glIsTexture(name);
        found.queries += glIsQuery(name);
        found.programs += glIsProgram(name);
        if (glIsBuffer(name))
        {
          GLint64 bytes = 0;
          glGetNamedBufferParameteri64v(name, GL_BUFFER_SIZE, &bytes);
          ++found.buffers;
          found.bytes += bytes;
        }
      }
    });
  return found;
}

TEST(DeviceEngine, LeaksNothingOverManyFrames)
{
  const TriangleMesh mesh = box({ 1.0, 0.7, 0.4 });
  MedialSolver solver(mesh);
  MedialAxisOptions options;
  options.field.engine = Engine::Device;
  const Grid grid = makeGrid(mesh.bounds(), 12, 0.1);
  const auto compute = [&](int frames)
  {
    for (int i = 0; i < frames; ++i)
    {
      solver.setPoints(scaled(mesh, i % 2 == 0 ? 1.0 : 0.9).points);
      EXPECT_GT(solver.computeAxis(grid, options).points.size(), 0u);
    }
  };
  compute(3);
  const DeviceObjects early = deviceObjects();
  EXPECT_GT(early.buffers, 10);
  EXPECT_GT(early.bytes, 10000);
  compute(47);
  const double before = residentMiB();
  compute(250);
  EXPECT_LT(residentMiB() - before, kAllowedGrowth);
  EXPECT_EQ(deviceObjects(), early);
}

TEST(DeviceEngine, LeavesNothingOnTheDevice)
{
  const auto compute = []
  {
    DeviceEngine engine;
    EXPECT_GT(computedBy(engine, ring(), tallGrid()).crossings.size(), 100u);
  };
  compute();
  const DeviceObjects before = deviceObjects();
  compute();
  EXPECT_EQ(deviceObjects(), before);
}

TEST(DeviceEngine, PassesItsOwnCheck)
{
  DistanceFieldOptions options;
  options.engine = Engine::Device;
  options.verify = true;
  for (const TriangleMesh& mesh : { ring(), randomSoup(40, 3) })
  {
    expectExactField(mesh, makeGrid(mesh.bounds(), 16, 0.3), options);
  }
}

/// Every tile of a coarse grid has hundreds of groups, so that the first lists do not suffice.
TEST(DeviceEngine, MakesRoomForLongLists)
{
  const TriangleMesh mesh = icosphere(1.0, 5);
  DistanceFieldOptions options;
  options.engine = Engine::Device;
  const Grid grid = makeGrid(mesh.bounds(), 11, 0.1);
  MedialSolver solver(mesh);
  DistanceField field = computeDistanceField(mesh, grid, options);
  expectExact(mesh, field, allVoxels(grid));
  FieldArrays arrays;
  arrays.distance = field.distance.data();
  const std::int64_t first =
    solver.computeField(grid, grid.wholeExtent(), arrays, options).dispatches;
  EXPECT_LT(solver.computeField(grid, grid.wholeExtent(), arrays, options).dispatches, first);
}

/// Each has a mesh, an engine and a grid of its own; the GPU thread takes turns with them.
TEST(DeviceEngine, ServesEightThreadsAtOnce)
{
  std::vector<std::thread> threads;
  for (int i = 0; i < 8; ++i)
  {
    threads.emplace_back(
      [i]
      {
        const TriangleMesh mesh =
          i % 2 == 0 ? box({ 1.0, 0.3 + 0.1 * i, 0.7 }) : torus(1.0, 0.2 + 0.05 * i, 12 + i, 8);
        const Grid grid = makeGrid(mesh.bounds(), 12 + 2 * i, 0.2);
        DistanceFieldOptions options;
        options.engine = Engine::Processor;
        const DistanceField expected = computeDistanceField(mesh, grid, options);
        options.engine = Engine::Device;
        for (int frame = 0; frame < 3; ++frame)
        {
          const DistanceField field = computeDistanceField(mesh, grid, options);
          EXPECT_EQ(field.statistics.engine, Engine::Device);
          const FieldDifference found = difference(mesh, field, expected);
          EXPECT_LE(found.distance, 1e-4) << "thread " << i;
          EXPECT_EQ(found.untiedSites, 0u) << "thread " << i;
        }
      });
  }
  for (std::thread& thread : threads)
  {
    thread.join();
  }
}

TEST(DeviceEngine, CanBeCancelledBetweenDispatches)
{
  RecordedProgress progress;
  progress.maxReports = queryDevice().software ? 4 : 1; // hardware is done within a few
  DistanceFieldOptions options;
  options.engine = Engine::Device;
  options.execution.progress = &progress;
  const TriangleMesh mesh = ring();
  expectError([&] { computeDistanceField(mesh, makeGrid(mesh.bounds(), 96, 0.1), options); },
    ErrorCode::Cancelled);
}

} // namespace
} // namespace medial::test
