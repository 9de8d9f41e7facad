#include "gl/fault.h"
#include "gl/gl_objects.h"
#include "gl/gpu_thread.h"
#include "gl/shader_program.h"
#include "gl/shader_source.h"
#include "medial/device.h"
#include "medial/error.h"
#include "support/errors.h"
#include "support/files.h"

#include <epoxy/gl.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <future>
#include <iostream>
#include <set>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

using namespace medial;
using test::readFile;
using test::TemporaryFolder;

namespace
{

namespace fs = std::filesystem;

/// 0 if the device is missing as documented. Asks twice, as the library tries again.
int exitCodeWithoutEgl()
{
  for (int attempt = 0; attempt < 2; ++attempt)
  {
    try
    {
      queryDevice();
      return 1;
    }
    catch (const Error& error)
    {
      if (error.code() != ErrorCode::NoGpu || std::string(error.what()).empty())
      {
        return 2;
      }
    }
  }
  return 0;
}

} // namespace

TEST(GpuThread, DescribesItsDevice)
{
  const Device device = queryDevice();
  EXPECT_FALSE(device.renderer.empty());
  EXPECT_FALSE(device.version.empty());
}

TEST(GpuThread, HasOneDevice)
{
  const Device device = gl::GpuThread::instance().device();
  EXPECT_EQ(&gl::GpuThread::instance(device.renderer), &gl::GpuThread::instance());
  EXPECT_THROW(gl::GpuThread::instance("Voodoo"), Error);
}

TEST(GpuThread, RunsJobsInOrderOnOneThread)
{
  std::vector<int> order;
  std::set<std::thread::id> threads;
  std::vector<std::future<void>> done;
  for (int i = 0; i < 50; ++i)
  {
    done.push_back(gl::GpuThread::instance().submit(
      [&, i]
      {
        order.push_back(i);
        threads.insert(std::this_thread::get_id());
      }));
  }
  done.back().get();
  EXPECT_TRUE(std::is_sorted(order.begin(), order.end()));
  EXPECT_EQ(order.size(), 50u);
  EXPECT_EQ(threads.size(), 1u);
  EXPECT_EQ(threads.count(std::this_thread::get_id()), 0u);
}

TEST(GpuThread, HandsExceptionsOfJobsToTheCaller)
{
  gl::GpuThread& thread = gl::GpuThread::instance();
  EXPECT_THROW(thread.run([] { throw std::range_error("from a job"); }), std::range_error);
  std::future<void> failing =
    thread.submit([] { throw Error(ErrorCode::GpuLimit, "from another"); });
  EXPECT_THROW(failing.get(), Error);
  bool ran = false;
  thread.run([&] { ran = true; });
  EXPECT_TRUE(ran);
}

TEST(GpuThread, HandsExceptionsOfConstructorsToTheCaller)
{
  struct Failing
  {
    Failing() { throw std::range_error("from a constructor"); }
  };
  EXPECT_THROW(gl::OnGpuThread<Failing>{}, std::range_error);
}

TEST(GpuThread, BuildsAndDestroysObjectsWhereTheyLive)
{
  struct Recorder
  {
    explicit Recorder(std::vector<std::thread::id>& ids)
      : seen(ids)
    {
      seen.push_back(std::this_thread::get_id());
    }
    ~Recorder() { seen.push_back(std::this_thread::get_id()); }
    std::vector<std::thread::id>& seen;
  };
  std::vector<std::thread::id> seen;
  {
    const gl::OnGpuThread<Recorder> object{ seen };
    EXPECT_EQ(seen.size(), 1u);
  }
  ASSERT_EQ(seen.size(), 2u);
  EXPECT_EQ(seen[0], seen[1]);
  EXPECT_NE(seen[0], std::this_thread::get_id());
}

TEST(GpuThread, DestroysWhatAFailedConstructorHasMadeWhereItLives)
{
  struct Member
  {
    ~Member() { *destroyedOn = std::this_thread::get_id(); }
    std::thread::id* destroyedOn;
  };
  struct FailingLate
  {
    explicit FailingLate(std::thread::id* destroyedOn)
      : member{ destroyedOn }
    {
      throw std::range_error("after the member");
    }
    Member member;
  };
  std::thread::id destroyedOn;
  std::thread::id gpuThread;
  gl::GpuThread::instance().run([&] { gpuThread = std::this_thread::get_id(); });
  EXPECT_THROW(gl::OnGpuThread<FailingLate>{ &destroyedOn }, std::range_error);
  EXPECT_EQ(destroyedOn, gpuThread);
}

TEST(GpuThread, TakesJobsFromManyThreads)
{
  int sum = 0;
  std::vector<std::thread> threads;
  for (int i = 0; i < 4; ++i)
  {
    threads.emplace_back(
      [&]
      {
        for (int job = 0; job < 100; ++job)
        {
          gl::GpuThread::instance().run([&] { ++sum; });
        }
      });
  }
  for (std::thread& thread : threads)
  {
    thread.join();
  }
  EXPECT_EQ(sum, 400);
}

namespace
{

/// A buffer in the context of the moment.
struct OneBuffer
{
  gl::Buffer buffer = gl::createBuffer();
};

void loseContext()
{
  gl::GpuThread::instance().run([] { gl::GpuThread::loseContext(); });
}

int contextNumber()
{
  int number = 0;
  gl::GpuThread::instance().run([&] { number = gl::GpuThread::contextNumber(); });
  return number;
}

} // namespace

TEST(GpuThread, ReplacesALostContext)
{
  const int before = contextNumber();
  EXPECT_EQ(contextNumber(), before);
  EXPECT_EQ(gl::GpuThread::contextNumber(), 0); // of another thread
  const Device device = queryDevice();
  loseContext();
  EXPECT_EQ(contextNumber(), before + 1);
  EXPECT_EQ(queryDevice().renderer, device.renderer);
  gl::GpuThread::instance().run([] { gl::checkGl("looking"); });
}

TEST(GpuThread, KeepsObjectsOfALostContextFromTheNewOne)
{
  auto old = std::make_unique<gl::OnGpuThread<OneBuffer>>();
  loseContext();
  gl::OnGpuThread<OneBuffer> fresh;
  const GLuint name = fresh.object().buffer.id();
  EXPECT_EQ(name, old->object().buffer.id()) << "contexts count alike";
  EXPECT_THROW(old->run([](OneBuffer& /*object*/) { FAIL() << "ran"; }), gl::ContextLost);
  EXPECT_THROW(old->submit([](OneBuffer& /*object*/) {}).get(), gl::ContextLost);
  old.reset();
  GLboolean isThere = GL_FALSE;
  fresh.run([&](OneBuffer& /*object*/) { isThere = glIsBuffer(name); });
  EXPECT_TRUE(isThere);
}

TEST(GpuThread, TriesAgainWhereALostContextCannotBeReplaced)
{
  gl::OnGpuThread<OneBuffer> old;
  loseContext();
  gl::injectFault(gl::Fault::ContextRefused);
  EXPECT_THROW(gl::GpuThread::instance(), Error);
  EXPECT_THROW(old.run([](OneBuffer& /*object*/) {}), gl::ContextLost);
  gl::OnGpuThread<OneBuffer> fresh;
  fresh.run([](OneBuffer& object) { EXPECT_TRUE(glIsBuffer(object.buffer.id())); });
}

/// As instances do that were made before, which ask for no new context by themselves.
TEST(GpuThread, RunsNothingWithoutAContext)
{
  gl::GpuThread& thread = gl::GpuThread::instance();
  loseContext();
  gl::injectFault(gl::Fault::ContextRefused);
  EXPECT_THROW(gl::GpuThread::instance(), Error);
  EXPECT_THROW(thread.run([] { FAIL() << "ran"; }), gl::ContextLost);
  EXPECT_THROW(thread.submit([] { FAIL() << "ran"; }).get(), gl::ContextLost);
  EXPECT_GT(contextNumber(), 0);
}

TEST(NoGpuDeathTest, WithoutAnyEglDriverTheErrorSaysSo)
{
  testing::GTEST_FLAG(death_test_style) = "threadsafe";
  const TemporaryFolder folder;
  EXPECT_EXIT(
    {
      setenv("__EGL_VENDOR_LIBRARY_DIRS", folder.path().c_str(), 1);
      std::exit(exitCodeWithoutEgl());
    },
    testing::ExitedWithCode(0), "");
}

TEST(NoGpuDeathTest, WithoutAnyEglLibraryTheErrorSaysSo)
{
  testing::GTEST_FLAG(death_test_style) = "threadsafe";
  const TemporaryFolder folder;
  // The child finds this file, which is no library, before the real one.
  std::ofstream{ folder.path() / "libEGL.so.1" } << "nothing";
  setenv("LD_LIBRARY_PATH", folder.path().c_str(), 1);
  EXPECT_EXIT(std::exit(exitCodeWithoutEgl()), testing::ExitedWithCode(0), "");
  unsetenv("LD_LIBRARY_PATH");
}

TEST(NoGpuDeathTest, WithoutAnyOpenGlLibraryTheErrorSaysSo)
{
  testing::GTEST_FLAG(death_test_style) = "threadsafe";
  const TemporaryFolder folder;
  std::ofstream{ folder.path() / "libGL.so.1" } << "nothing";
  std::ofstream{ folder.path() / "libOpenGL.so.0" } << "nothing";
  setenv("LD_LIBRARY_PATH", folder.path().c_str(), 1);
  EXPECT_EXIT(std::exit(exitCodeWithoutEgl()), testing::ExitedWithCode(0), "");
  unsetenv("LD_LIBRARY_PATH");
}

TEST(GlLogDeathTest, HasWhatTheDriverSays)
{
  testing::GTEST_FLAG(death_test_style) = "threadsafe";
  const TemporaryFolder folder;
  const std::string file = (folder.path() / "driver.log").string();
  const auto speak = [&]
  {
    setenv("MEDIAL_GL_LOG", file.c_str(), 1);
    gl::GpuThread::instance().run(
      []
      {
        glDebugMessageInsert(GL_DEBUG_SOURCE_APPLICATION, GL_DEBUG_TYPE_PERFORMANCE, 1,
          GL_DEBUG_SEVERITY_LOW, -1, "that was slow");
      });
    const std::string text = readFile(file);
    const bool said = text.rfind(queryDevice().renderer, 0) == 0 &&
      text.find("\nperformance: that was slow\n") != std::string::npos;
    std::exit(said && deviceDebugLog().empty() ? 0 : 1);
  };
  EXPECT_EXIT(speak(), testing::ExitedWithCode(0), "");
}

TEST(GlLogDeathTest, ThatCannotBeWrittenIsAnError)
{
  testing::GTEST_FLAG(death_test_style) = "threadsafe";
  const auto fail = []
  {
    setenv("MEDIAL_GL_LOG", "/no folder/driver.log", 1);
    try
    {
      queryDevice();
    }
    catch (const Error& error)
    {
      std::exit(error.code() == ErrorCode::CannotWrite ? 0 : 1);
    }
    std::exit(2);
  };
  EXPECT_EXIT(fail(), testing::ExitedWithCode(0), "");
}

TEST(ShaderSource, HoldsEveryFileOfTheShadersFolder)
{
  std::size_t files = 0;
  for (const auto& entry : fs::recursive_directory_iterator(MEDIAL_SHADER_FOLDER))
  {
    const std::string name = entry.path().filename().string();
    const bool isWhole = entry.is_regular_file() && entry.path().extension() != ".glsl";
    const std::string text = isWhole ? readFile(entry.path().string()) : "";
    if (isWhole && text.find("#include") == std::string::npos)
    {
      EXPECT_EQ(text, gl::shaderSource(name)) << name;
    }
    else if (isWhole)
    {
      EXPECT_EQ(std::string(gl::shaderSource(name)).find("#include"), std::string::npos) << name;
    }
    files += isWhole ? 1 : 0;
  }
  EXPECT_EQ(files, gl::kEmbeddedShaderCount);
}

/// Mesa keeps what it has compiled, and warns about a shader the first time only.
TEST(ShaderDeathTest, EveryOneIsCompiledWithoutAWarning)
{
  testing::GTEST_FLAG(death_test_style) = "threadsafe";
  const auto compileAll = []
  {
    setenv("MESA_SHADER_CACHE_DISABLE", "true", 1);
    gl::GpuThread::instance().run(
      []
      {
        for (std::size_t i = 0; i < gl::kEmbeddedShaderCount; ++i)
        {
          const std::string name = gl::kEmbeddedShaders[i].name;
          const std::string kind = name.substr(name.find('.'));
          if (kind == ".comp")
          {
            gl::ShaderProgram{ name };
          }
          else if (kind == ".frag")
          {
            gl::ShaderProgram(name == "polygons.frag" ? "polygons.vert" : "atlas_pass.vert", name);
          }
        }
      });
    const std::string log = deviceDebugLog();
    std::cerr << log;
    return log.empty();
  };
  EXPECT_EXIT(std::exit(compileAll() ? 0 : 1), testing::ExitedWithCode(0), "");
}

TEST(ShaderSource, OfAnUnknownNameIsAnError)
{
  test::expectError([&] { gl::shaderSource("missing.frag"); }, ErrorCode::ShaderBuild);
}
