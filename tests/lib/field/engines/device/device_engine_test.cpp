// What only the engine `device` promises: few bytes, faults that it survives, checks of itself.
#include "field/engines/device/device_engine.h"

#include "base/run.h"
#include "field/array_sink.h"
#include "field/engines/device/element_order.h"
#include "field/engines/fallback_engine.h"
#include "field/engines/processor/processor_engine.h"
#include "field/engines/rasteriser/rasteriser_engine.h"
#include "field/field_pipeline.h"
#include "gl/fault.h"
#include "gl/gpu_thread.h"
#include "gl/shader_program.h"
#include "medial/compute_distance_field.h"
#include "medial/error.h"
#include "medial/medial_solver.h"
#include "support/collecting_sink.h"
#include "support/field_checks.h"
#include "support/resident_memory.h"
#include "support/shapes.h"

#include <epoxy/gl.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numeric>
#include <string>
#include <thread>
#include <vector>

namespace medial::test
{
namespace
{

TriangleMesh ring()
{
  return torus(1.0, 0.35, 24, 12);
}

/// Several slabs with little memory.
Grid tallGrid()
{
  return { { -1.45, -1.45, -0.6 }, { 0.09, 0.09, 0.031 }, { 33, 33, 40 } };
}

/// A field, and what its run says.
struct Computed
{
  DistanceField field;
  std::vector<Crossing> crossings;
};

/// Computes a field with crossings in slabs of few slices.
Computed computedBy(FieldEngine& engine, const TriangleMesh& mesh, const Grid& grid,
  bool verify = false)
{
  const MeshConnectivity connectivity = analyseConnectivity(mesh);
  DistanceFieldOptions options;
  options.memoryMiB = 1;
  options.verify = verify;
  const Extent extent = grid.wholeExtent();
  SurfaceOrienter orienter;
  FieldPipeline pipeline(mesh, connectivity, grid, extent, options, orienter,
    Run(options.execution));
  const std::size_t bytes = (std::size_t{ 1 } << 20) / (33 * 33 * 8);
  CollectingSink sink(extent, bytes);
  Computed computed;
  computed.crossings = pipeline.run(engine, sink, { 60.0, Side::Interior });
  computed.field.grid = grid;
  computed.field.distance = sink.distance;
  computed.field.closestSite = sink.site;
  computed.field.statistics = pipeline.statistics();
  return computed;
}

void expectSameField(const Computed& a, const Computed& b)
{
  ASSERT_EQ(a.field.distance.size(), b.field.distance.size());
  const FieldDifference found = difference(ring(), a.field, b.field);
  EXPECT_LE(found.distance, 1e-3);
  EXPECT_EQ(found.untiedSites, 0u);
  EXPECT_NEAR(static_cast<double>(a.crossings.size()), static_cast<double>(b.crossings.size()),
    0.02 * static_cast<double>(b.crossings.size()));
}

std::unique_ptr<FieldEngine> makeDevice()
{
  return std::make_unique<DeviceEngine>();
}

/// A fault, after so many opportunities, and the error that it is where the device was asked for by
/// name.
struct FaultCase
{
  const char* name;
  gl::Fault fault;
  int opportunities;
  ErrorCode code;
};

std::ostream& operator<<(std::ostream& out, const FaultCase& fault)
{
  return out << fault.name;
}

class DeviceFault : public testing::TestWithParam<FaultCase>
{
protected:
  void SetUp() override
  {
    // So that shaders are compiled again.
    gl::GpuThread::instance().run([] { gl::releaseProgramCache(); });
  }
  void TearDown() override { gl::injectFault(gl::Fault::None); }
};

TEST_P(DeviceFault, LeadsToTheProcessorWithANote)
{
  FallbackEngine engine(makeDevice);
  EXPECT_EQ(engine.kind(), Engine::Device);
  gl::injectFault(GetParam().fault, GetParam().opportunities);
  const Computed computed = computedBy(engine, ring(), tallGrid(), true);
  EXPECT_EQ(computed.field.statistics.engine, Engine::Processor);
  EXPECT_NE(computed.field.statistics.note.find("the engine device failed ("), std::string::npos);
  EXPECT_EQ(computed.field.statistics.note.find('\n'), std::string::npos);
  FallbackEngine sound(makeDevice);
  const Computed expected = computedBy(sound, ring(), tallGrid());
  EXPECT_EQ(expected.field.statistics.engine, Engine::Device);
  EXPECT_EQ(expected.field.statistics.note, "");
  expectSameField(computed, expected);
  // From now on without a try, except after a reset, which leaves a device as good as new.
  const bool renewed = GetParam().fault == gl::Fault::ContextLost;
  const Computed again = computedBy(engine, ring(), tallGrid());
  EXPECT_EQ(again.field.statistics.engine, renewed ? Engine::Device : Engine::Processor);
  EXPECT_EQ(again.field.statistics.note.empty(), renewed);
  EXPECT_EQ(again.field.statistics.device.has_value(), renewed);
  expectSameField(again, expected);
}

TEST_P(DeviceFault, IsAnErrorOfTheDeviceAskedForByName)
{
  DeviceEngine engine;
  gl::injectFault(GetParam().fault, GetParam().opportunities);
  try
  {
    computedBy(engine, ring(), tallGrid(), true);
    FAIL() << "no error";
  }
  catch (const Error& error)
  {
    EXPECT_EQ(error.code(), GetParam().code) << error.what();
  }
  EXPECT_GT(computedBy(engine, ring(), tallGrid()).crossings.size(), 100u); // works afterwards
}

INSTANTIATE_TEST_SUITE_P(All, DeviceFault,
  testing::Values(FaultCase{ "shader", gl::Fault::ShaderRefused, 2, ErrorCode::ShaderBuild },
    FaultCase{ "allocation", gl::Fault::AllocationRefused, 7, ErrorCode::OutOfMemory },
    FaultCase{ "fence", gl::Fault::NeverReady, 1, ErrorCode::NoGpu },
    FaultCase{ "reset", gl::Fault::ContextLost, 40, ErrorCode::NoGpu },
    FaultCase{ "resetBetweenSlabs", gl::Fault::ContextLost, 75, ErrorCode::NoGpu },
    FaultCase{ "wrongResult", gl::Fault::WrongResult, 1, ErrorCode::NoGpu }),
  [](const auto& test) { return std::string(test.param.name); });

/// A device that is reset.
class DeviceReset : public testing::Test
{
protected:
  static constexpr int kAmidstTheField = 40;
  void TearDown() override { gl::injectFault(gl::Fault::None); }

  /// Computes a field, during which the device is reset.
  static Computed computedDuringReset(FieldEngine& engine)
  {
    gl::injectFault(gl::Fault::ContextLost, kAmidstTheField);
    Computed computed = computedBy(engine, ring(), tallGrid());
    EXPECT_NE(computed.field.statistics.note.find("the device was reset"), std::string::npos);
    return computed;
  }
};

TEST_F(DeviceReset, LeadsToTheProcessorIfThereIsNoContextAfterIt)
{
  FallbackEngine engine(makeDevice);
  computedDuringReset(engine);
  gl::injectFault(gl::Fault::ContextRefused);
  const Computed refused = computedBy(engine, ring(), tallGrid());
  EXPECT_EQ(refused.field.statistics.engine, Engine::Processor);
  EXPECT_EQ(refused.field.statistics.note,
    "the engine device failed (no context can be made), so the processor did the work");
  const Computed last = computedBy(engine, ring(), tallGrid());
  EXPECT_EQ(last.field.statistics.engine, Engine::Processor);
  EXPECT_EQ(last.field.statistics.note, refused.field.statistics.note);
  FallbackEngine another(makeDevice); // the thread tries again where someone asks for it
  EXPECT_EQ(computedBy(another, ring(), tallGrid()).field.statistics.engine, Engine::Device);
}

TEST_F(DeviceReset, IsForgivenOnce)
{
  FallbackEngine engine(makeDevice);
  computedDuringReset(engine);
  EXPECT_EQ(computedBy(engine, ring(), tallGrid()).field.statistics.engine, Engine::Device);
  computedDuringReset(engine);
  EXPECT_EQ(computedBy(engine, ring(), tallGrid()).field.statistics.engine, Engine::Processor);
}

TEST_F(DeviceReset, LosesWhatOtherEnginesHadOnTheDevice)
{
  DeviceEngine bystander;
  const Computed before = computedBy(bystander, ring(), tallGrid());
  FallbackEngine engine(makeDevice);
  computedDuringReset(engine);
  EXPECT_EQ(computedBy(engine, ring(), tallGrid()).field.statistics.engine, Engine::Device);
  EXPECT_THROW(computedBy(bystander, ring(), tallGrid()), gl::ContextLost);
  expectSameField(computedBy(bystander, ring(), tallGrid()), before);
}

TEST_F(DeviceReset, LosesWhatTheRasteriserHadOnTheDeviceOnce)
{
  RasteriserEngine bystander({});
  const Computed before = computedBy(bystander, ring(), tallGrid());
  FallbackEngine engine(makeDevice);
  computedDuringReset(engine);
  EXPECT_EQ(computedBy(engine, ring(), tallGrid()).field.statistics.engine, Engine::Device);
  EXPECT_THROW(computedBy(bystander, ring(), tallGrid()), gl::ContextLost);
  expectSameField(computedBy(bystander, ring(), tallGrid()), before);
}

TEST(DeviceEngine, ThatCannotBeMadeLeadsToTheProcessor)
{
  FallbackEngine engine(
    []() -> std::unique_ptr<FieldEngine> { throw Error(ErrorCode::NoGpu, "no device\nat all"); });
  EXPECT_EQ(engine.kind(), Engine::Processor);
  const Computed computed = computedBy(engine, ring(), tallGrid());
  EXPECT_EQ(computed.field.statistics.note,
    "the engine device failed (no device), so the processor did the work");
}

TEST(DeviceEngine, LeavesAJobThatIsTooMuchToTheProcessorAndTakesTheNext)
{
  FallbackEngine engine(makeDevice);
  Grid far = tallGrid();
  far.origin = { 1e5, 0.0, 0.0 };
  const Computed tooFar = computedBy(engine, ring(), far);
  EXPECT_EQ(tooFar.field.statistics.engine, Engine::Processor);
  EXPECT_NE(tooFar.field.statistics.note, "");
  const Computed near = computedBy(engine, ring(), tallGrid());
  EXPECT_EQ(near.field.statistics.engine, Engine::Device);
  EXPECT_EQ(near.field.statistics.note, "");
}

TEST(DeviceEngine, DoesNotTakeAnErrorOfTheSinkForItsOwn)
{
  struct FullSink : CollectingSink
  {
    using CollectingSink::CollectingSink;
    void stored(const Extent& slab) override
    {
      CollectingSink::stored(slab);
      ++calls;
      throw Error(ErrorCode::OutOfMemory, "the sink is full");
    }
    int calls = 0;
  };
  const MeshConnectivity connectivity = analyseConnectivity(ring());
  const Extent extent = tallGrid().wholeExtent();
  const DistanceFieldOptions options;
  const TriangleMesh mesh = ring();
  SurfaceOrienter orienter;
  FieldPipeline pipeline(mesh, connectivity, tallGrid(), extent, options, orienter,
    medial::Run(options.execution));
  FallbackEngine engine(makeDevice);
  FullSink sink(extent, 8);
  try
  {
    pipeline.run(engine, sink);
    FAIL() << "no error";
  }
  catch (const Error& error)
  {
    EXPECT_STREQ(error.what(), "the sink is full");
  }
  EXPECT_EQ(sink.calls, 1);
  EXPECT_EQ(engine.kind(), Engine::Device);
}

/// Lowers the limit of storage buffers.
struct StorageLimit
{
  explicit StorageLimit(std::int64_t bytes) { gl::limitStorageBuffers(bytes); }
  ~StorageLimit() { gl::limitStorageBuffers(0); }
  StorageLimit(const StorageLimit&) = delete;
  StorageLimit& operator=(const StorageLimit&) = delete;
};

constexpr std::int64_t kMiB = 1 << 20;

TEST(DeviceEngine, RefusesWhatDoesNotFitAStorageBuffer)
{
  const Grid wide{ { -1.5, -1.5, 0.0 }, { 0.005, 0.005, 0.005 }, { 600, 600, 1 } };
  const StorageLimit limit(kMiB);
  DeviceEngine engine;
  try
  {
    computedBy(engine, ring(), wide);
    FAIL() << "no error";
  }
  catch (const Error& error)
  {
    EXPECT_EQ(error.code(), ErrorCode::GpuLimit);
    EXPECT_NE(std::string(error.what()).find("the driver's limit of 1048576"), std::string::npos)
      << error.what();
  }
  // Slabs become thinner, where this helps.
  EXPECT_EQ(computedBy(engine, ring(), tallGrid()).field.statistics.engine, Engine::Device);
}

/// Triangles, segments and points, more than fit the limit below.
TriangleMesh largeMixture()
{
  TriangleMesh mesh = appended(randomSoup(4000, 5),
    makeMesh({ { 0.1, 0.2, 0.9 }, { -0.9, 0.2, 0.9 }, { 0.5, 0.5, 0.5 } }, {}, { { 0, 1 } },
      { 2 }));
  return appended(mesh, torus(1.0, 0.3, 40, 20));
}

TEST(DeviceEngine, SplitsMeshesLargerThanAStorageBuffer)
{
  struct Case
  {
    const char* name;
    TriangleMesh mesh;
    std::int64_t limit;
    int resolution;
  };
  const Case cases[] = { { "sphere", icosphere(1.0, 6), kMiB, 14 },
    { "ring", torus(1.0, 0.35, 80, 40), kMiB / 4, 40 },
    { "mixture", largeMixture(), kMiB / 4, 24 } };
  for (const Case& one : cases)
  {
    SCOPED_TRACE(one.name);
    const Grid grid = makeGrid(one.mesh.bounds(), one.resolution, 0.2);
    ProcessorEngine processor;
    const Computed expected = computedBy(processor, one.mesh, grid);
    const StorageLimit limit(one.limit);
    ASSERT_GT(DeviceMesh::largestBuffer(one.mesh, analyseConnectivity(one.mesh)), one.limit);
    DeviceEngine engine;
    const Computed split = computedBy(engine, one.mesh, grid, true);
    EXPECT_EQ(split.field.statistics.engine, Engine::Device);
    EXPECT_GT(split.field.statistics.dispatches, 0);
    const FieldDifference found = difference(one.mesh, split.field, expected.field);
    EXPECT_LE(found.distance, 1e-4);
    EXPECT_EQ(found.untiedSites, 0u);
    EXPECT_NEAR(static_cast<double>(split.crossings.size()),
      static_cast<double>(expected.crossings.size()),
      0.002 * static_cast<double>(expected.crossings.size()));
    // The same bytes in the next frame, which moves positions only.
    const Computed again = computedBy(engine, one.mesh, grid);
    EXPECT_EQ(again.field.distance, split.field.distance);
    EXPECT_EQ(again.field.closestSite, split.field.closestSite);
    EXPECT_LT(again.field.statistics.bytesUploaded, split.field.statistics.bytesUploaded / 2);
  }
}

TEST_F(DeviceReset, AmidstAMeshInPartsLeadsToTheProcessor)
{
  const TriangleMesh mesh = torus(1.0, 0.35, 80, 40);
  FallbackEngine engine(makeDevice);
  const StorageLimit limit(kMiB / 4);
  gl::injectFault(gl::Fault::ContextLost, 200);
  const Computed computed = computedBy(engine, mesh, tallGrid());
  EXPECT_EQ(computed.field.statistics.engine, Engine::Processor);
  EXPECT_NE(computed.field.statistics.note, "");
  const Computed again = computedBy(engine, mesh, tallGrid());
  EXPECT_EQ(again.field.statistics.engine, Engine::Device);
  const FieldDifference found = difference(mesh, computed.field, again.field);
  EXPECT_LE(found.distance, 1e-4);
  EXPECT_EQ(found.untiedSites, 0u);
}

TEST(DeviceEngine, SplitsMeshesInMotionWithAllArraysAndSigns)
{
  const TriangleMesh mesh = torus(1.0, 0.35, 60, 30);
  const StorageLimit limit(kMiB / 4);
  MedialSolver solver(mesh);
  for (const SignMethod sign : { SignMethod::Winding, SignMethod::Pseudonormal, SignMethod::None })
  {
    DistanceFieldOptions options;
    options.sign = sign;
    options.engine = Engine::Device;
    for (const double factor : { 1.0, 0.8 })
    {
      const TriangleMesh moved = scaled(mesh, factor);
      const Grid grid = makeGrid(moved.bounds(), 24, 0.2);
      expectExact(moved, computeDistanceField(moved, grid, options), allVoxels(grid));
      DistanceField field;
      field.grid = grid;
      field.distance.resize(grid.pointCount());
      field.closestSite.resize(grid.pointCount());
      FieldArrays arrays;
      arrays.distance = field.distance.data();
      arrays.closestSite = field.closestSite.data();
      solver.setPoints(moved.points);
      solver.computeField(grid, grid.wholeExtent(), arrays, options);
      DistanceFieldOptions byProcessor = options;
      byProcessor.engine = Engine::Processor;
      const FieldDifference found =
        difference(moved, field, computeDistanceField(moved, grid, byProcessor));
      EXPECT_LE(found.distance, 1e-4);
      EXPECT_EQ(found.untiedSites, 0u);
    }
  }
}

/// The points of a site.
std::vector<int> cornersOf(std::size_t site, const TriangleMesh& mesh,
  const MeshConnectivity& connectivity)
{
  const std::size_t faces = mesh.triangles.size();
  if (site < faces)
  {
    return { mesh.triangles[site].begin(), mesh.triangles[site].end() };
  }
  if (site - faces < connectivity.edges.size())
  {
    const auto& edge = connectivity.edges[site - faces];
    return { edge.begin(), edge.end() };
  }
  return { static_cast<int>(site - faces - connectivity.edges.size()) };
}

TEST(MeshParts, HaveEveryElementOnceAndTheNamesOfTheWholeMesh)
{
  const TriangleMesh mesh = largeMixture();
  const MeshConnectivity connectivity = analyseConnectivity(mesh);
  const auto firstEdge = static_cast<std::int32_t>(mesh.triangles.size());
  std::vector<int> found(firstEdge + connectivity.edges.size() + mesh.points.size());
  const std::vector<MeshPart> parts = splitMesh(mesh, connectivity, 700);
  EXPECT_GT(parts.size(), 5u);
  for (const MeshPart& part : parts)
  {
    const std::size_t faces = part.mesh.triangles.size();
    const std::size_t edges = part.connectivity.edges.size();
    EXPECT_LE(faces + part.mesh.segments.size() + part.mesh.vertices.size(), 700u);
    ASSERT_EQ(part.sites.size(), faces + edges + part.points.size());
    for (std::size_t i = 0; i < part.sites.size(); ++i)
    {
      const std::int32_t site = part.sites[i];
      ++found[site];
      std::vector<int> corners = cornersOf(i, part.mesh, part.connectivity);
      const std::vector<int> expected = cornersOf(site, mesh, connectivity);
      ASSERT_EQ(corners.size(), expected.size());
      for (int& corner : corners)
      {
        corner = part.points[corner];
      }
      EXPECT_TRUE(std::is_permutation(corners.begin(), corners.end(), expected.begin()));
    }
  }
  for (std::int32_t site = 0; site < static_cast<std::int32_t>(found.size()); ++site)
  {
    EXPECT_GE(found[site], 1) << site;
    EXPECT_TRUE(site >= firstEdge || found[site] == 1) << site;
  }
}

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
  class Cancelling : public Progress
  {
  public:
    void report(double /*fraction*/, const char* /*phase*/) override { ++reports; }
    bool cancelled() override { return reports > 3; }
    int reports = 0;
  };
  Cancelling progress;
  DistanceFieldOptions options;
  options.engine = Engine::Device;
  options.execution.progress = &progress;
  const TriangleMesh mesh = ring();
  try
  {
    computeDistanceField(mesh, makeGrid(mesh.bounds(), 96, 0.1), options);
    FAIL() << "no error";
  }
  catch (const Error& error)
  {
    EXPECT_EQ(error.code(), ErrorCode::Cancelled);
  }
}

/// Elements of very different sizes, and some of every kind.
TEST(ElementOrder, HasEveryElementOnceAndGroupsOfOneSize)
{
  TriangleMesh mesh = makeMesh({ { 0.0, 0.0, 0.0 }, { 1.0, 0.2, 0.0 }, { 0.4, 0.9, 0.1 },
                                 { 0.0, 0.5, 0.8 }, { 1.0, 0.5, 0.7 }, { 0.5, 0.1, 1.0 } },
    { { 0, 1, 2 } }, { { 3, 4 }, { 0, 1 } }, { 5, 2 });
  mesh = appended(mesh, scaled(mesh, 1000.0));
  mesh = appended(mesh, torus(1.0, 0.3, 16, 8));
  const MeshConnectivity connectivity = analyseConnectivity(mesh);
  const std::vector<std::int32_t> order = orderElements(mesh, connectivity);
  EXPECT_EQ(order.size() % kGroupSize, 0u);
  std::vector<std::int32_t> sites(order);
  sites.erase(std::remove(sites.begin(), sites.end(), -1), sites.end());
  std::sort(sites.begin(), sites.end());
  EXPECT_EQ(std::adjacent_find(sites.begin(), sites.end()), sites.end());
  // All faces, and of each of the two small meshes an edge and a vertex of no face.
  ASSERT_EQ(sites.size(), mesh.triangles.size() + 4);
  std::vector<std::int32_t> faces(mesh.triangles.size());
  std::iota(faces.begin(), faces.end(), 0);
  EXPECT_TRUE(std::equal(faces.begin(), faces.end(), sites.begin()));
  EXPECT_GT(order.size(), sites.size());
}

} // namespace
} // namespace medial::test
