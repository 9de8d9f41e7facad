// Faults of devices: the processor goes on, or the device asked for by name is to blame.
#include "device_runs.h"
#include "field/engines/fallback_engine.h"
#include "field/engines/rasteriser/rasteriser_engine.h"
#include "gl/context_lost.h"
#include "gl/fault.h"
#include "gl/gpu_thread.h"
#include "gl/shader_program.h"
#include "medial/error.h"

#include "support/errors.h"

#include <gtest/gtest.h>

#include <memory>
#include <ostream>
#include <string>

namespace medial::test
{
namespace
{

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
  expectError([&] { computedBy(engine, ring(), tallGrid(), true); }, GetParam().code);
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

  /// Expects that an engine loses what it had on the device when another one resets it, and once.
  static void expectLostOnce(FieldEngine& bystander)
  {
    const Computed before = computedBy(bystander, ring(), tallGrid());
    FallbackEngine engine(makeDevice);
    computedDuringReset(engine);
    EXPECT_EQ(computedBy(engine, ring(), tallGrid()).field.statistics.engine, Engine::Device);
    EXPECT_THROW(computedBy(bystander, ring(), tallGrid()), gl::ContextLost);
    expectSameField(computedBy(bystander, ring(), tallGrid()), before);
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
  expectLostOnce(bystander);
}

TEST_F(DeviceReset, LosesWhatTheRasteriserHadOnTheDeviceOnce)
{
  RasteriserEngine bystander({});
  expectLostOnce(bystander);
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

TEST(FallbackEngine, IsTheDeviceOnceThereIsWorkEnough)
{
  const double work = 25e-9 * static_cast<double>(tallGrid().pointCount()) +
    1e-5 * static_cast<double>(ring().triangles.size());
  FallbackEngine engine(makeDevice, 1.5 * work);
  const Computed first = computedBy(engine, ring(), tallGrid());
  EXPECT_EQ(first.field.statistics.engine, Engine::Processor);
  EXPECT_FALSE(first.field.statistics.device.has_value());
  EXPECT_EQ(first.field.statistics.note, "");
  const Computed second = computedBy(engine, ring(), tallGrid());
  EXPECT_EQ(second.field.statistics.engine, Engine::Device);
  EXPECT_TRUE(second.field.statistics.device.has_value());
  expectSameField(first, second);
}

TEST(FallbackEngine, StaysWithTheProcessorIfNoDeviceIsWorthHaving)
{
  FallbackEngine engine([]() -> std::unique_ptr<FieldEngine> { return nullptr; });
  const Computed computed = computedBy(engine, ring(), tallGrid());
  EXPECT_EQ(computed.field.statistics.engine, Engine::Processor);
  EXPECT_EQ(computed.field.statistics.note, "");
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

} // namespace
} // namespace medial::test
