#include "medial/error.h"
#include "medial/medial_solver.h"
#include "support/printing.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <memory>
#include <string>
#include <vector>

#include <sys/wait.h>
#include <unistd.h>

// How solvers end together with their process, and what is left of them in a child. Each test runs
// in a process of its own, which an alarm ends if it hangs.

namespace medial::test
{
namespace
{

constexpr unsigned kMaxSeconds = 60;

class SolverProcessDeathTest : public testing::TestWithParam<Engine>
{
protected:
  SolverProcessDeathTest() { testing::GTEST_FLAG(death_test_style) = "threadsafe"; }
};

/// The distance at the corner of a small grid.
float distanceBy(MedialSolver& solver, Engine engine)
{
  const Grid grid = makeGrid(solver.mesh().bounds(), 12);
  std::vector<float> distance(static_cast<std::size_t>(grid.pointCount()));
  FieldArrays arrays;
  arrays.distance = distance.data();
  DistanceFieldOptions options;
  options.engine = engine;
  solver.computeField(grid, grid.wholeExtent(), arrays, options);
  return distance[0];
}

/// What `solver` says in a child; empty where it computes.
std::string refusal(MedialSolver& solver, Engine engine)
{
  try
  {
    distanceBy(solver, engine);
    return "";
  }
  catch (const Error& error)
  {
    return error.code() == ErrorCode::NoGpu ? error.what() : "another error";
  }
}

/// Runs `work` in a child by fork(). The child ends by _exit(), as those of Python's
/// multiprocessing do: in exit() Mesa waits for threads that only the parent has.
template <typename Work>
int exitCodeOfChild(const Work& work)
{
  const pid_t child = fork();
  if (child == 0)
  {
    alarm(kMaxSeconds / 2);
    _exit(work());
  }
  int status = 0;
  waitpid(child, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

TEST_P(SolverProcessDeathTest, ASolverThatIsOlderThanTheGpuThreadMayOutliveIt)
{
  const auto compute = [&]
  {
    alarm(kMaxSeconds);
    static MedialSolver solver(box({ 1.0, 0.7, 0.4 })); // destroyed after what it makes now
    return distanceBy(solver, GetParam()) > 0.0F ? 0 : 1;
  };
  EXPECT_EXIT(std::exit(compute()), testing::ExitedWithCode(0), "");
}

TEST_P(SolverProcessDeathTest, AChildComputesOrSaysWhyNot)
{
  const auto compute = [&]
  {
    alarm(kMaxSeconds);
    auto solver = std::make_unique<MedialSolver>(box({ 1.0, 0.7, 0.4 }));
    const float distance = distanceBy(*solver, GetParam());
    return exitCodeOfChild(
      [&]
      {
        const bool forked = GetParam() != Engine::Processor;
        const Engine drawing = forked ? GetParam() : Engine::Rasteriser;
        const std::string here = refusal(*solver, drawing);
        MedialSolver another(solver->mesh());
        const std::string there = refusal(another, drawing);
        const bool expected = forked ? here.find("fork()") != std::string::npos && here == there
                                     : here.empty() && there.empty();
        solver.reset();
        const float again = distanceBy(another, Engine::Processor);
        return expected && std::abs(again - distance) < 1e-4F ? 0 : 1;
      });
  };
  EXPECT_EXIT(std::exit(compute()), testing::ExitedWithCode(0), "");
}

INSTANTIATE_TEST_SUITE_P(Engines, SolverProcessDeathTest,
  testing::Values(Engine::Processor, Engine::Device, Engine::Rasteriser));

} // namespace
} // namespace medial::test
