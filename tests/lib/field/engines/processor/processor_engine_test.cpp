#include "medial/compute_distance_field.h"
#include "medial/compute_medial_axis.h"
#include "medial/error.h"
#include "medial/medial_solver.h"
#include "support/files.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <iostream>
#include <string>

namespace medial::test
{
namespace
{

constexpr const char* kOpenGlLibraries[] = { "libEGL", "libGL.", "libGLX", "libOpenGL",
  "libGLdispatch", "_dri.so", "libgallium", "libLLVM" };

/// A folder of files that have the names of OpenGL's libraries but are not libraries.
class NoOpenGl
{
public:
  NoOpenGl()
  {
    for (const char* name : { "libEGL.so.1", "libGL.so.1", "libOpenGL.so.0" })
    {
      medial::test::writeFile(folder_.file(name), "nothing");
    }
    // The child finds these before the real ones.
    setenv("LD_LIBRARY_PATH", folder_.path().c_str(), 1);
  }
  ~NoOpenGl() { unsetenv("LD_LIBRARY_PATH"); }
  NoOpenGl(const NoOpenGl&) = delete;
  NoOpenGl& operator=(const NoOpenGl&) = delete;

private:
  medial::test::TemporaryFolder folder_;
};

/// Whether this process has mapped any library of OpenGL.
bool openGlIsLoaded()
{
  std::ifstream maps("/proc/self/maps");
  for (std::string line; std::getline(maps, line);)
  {
    for (const char* library : kOpenGlLibraries)
    {
      if (line.find(library) != std::string::npos)
      {
        std::cerr << line << "\n";
        return true;
      }
    }
  }
  return false;
}

/// The engine's refusal, or what it used.
std::string outcomeOf(const DistanceFieldOptions& options)
{
  const TriangleMesh mesh = torus(1.0, 0.4, 16, 8);
  try
  {
    const DistanceField field = computeDistanceField(mesh, makeGrid(mesh.bounds(), 20), options);
    return field.statistics.device ? "computed with a device" : "computed";
  }
  catch (const Error& error)
  {
    return error.code() == ErrorCode::NoGpu ? error.what() : "another error";
  }
}

/// Exits with 0 if everything that does not draw has worked.
void computeEverything()
{
  MedialAxisOptions options;
  bool good = outcomeOf(options.field) == "computed";
  MedialSolver solver(torus(1.0, 0.4, 16, 8));
  const Grid grid = makeGrid(solver.mesh().bounds(), 20);
  for (const Topology topology : { Topology::Selected, Topology::Preserve })
  {
    options.topology = topology;
    const MedialAxis axis = solver.computeAxis(grid, options);
    good = good && axis.cellCount() > 0 && !axis.statistics.device;
  }
  good = good && !openGlIsLoaded();
  DistanceFieldOptions drawing;
  drawing.engine = Engine::Rasteriser;
  DistanceFieldOptions demanding;
  demanding.requireHardware = true;
  for (const DistanceFieldOptions& refused : { drawing, demanding })
  {
    const std::string outcome = outcomeOf(refused);
    std::cerr << outcome << "\n";
    good = good && outcome.find("libEGL.so.1 cannot be loaded") != std::string::npos;
  }
  std::exit(good ? 0 : 1);
}

TEST(ProcessorEngineDeathTest, ComputesWhereThereIsNoOpenGl)
{
  testing::GTEST_FLAG(death_test_style) = "threadsafe";
  const NoOpenGl none;
  EXPECT_EXIT(computeEverything(), testing::ExitedWithCode(0), "libEGL.so.1");
}

/// Where there is OpenGL, the processor leaves it alone.
TEST(ProcessorEngineDeathTest, LoadsNoOpenGl)
{
  testing::GTEST_FLAG(death_test_style) = "threadsafe";
  EXPECT_EXIT(
    {
      const std::string outcome = outcomeOf({});
      std::exit(outcome == "computed" && !openGlIsLoaded() ? 0 : 1);
    },
    testing::ExitedWithCode(0), "");
}

} // namespace
} // namespace medial::test
