#include "program.h"
#include "support/mesh_texts.h"

#include "support/shapes.h"
#include "support/virtual_display.h"

#include <gtest/gtest.h>

#include <chrono>
#include <thread>

namespace medial::test
{
namespace
{

class ViewerCommand : public ::testing::Test
{
protected:
  ViewerCommand() { writeFile(input, objText(box({ 1.0, 0.7, 0.4 }))); }

  // The one line that a run prints, which must fail.
  std::string failure(const std::vector<std::string>& arguments, int exitCode,
    const RunOptions& options = {})
  {
    const Outcome outcome = runMedialViewer(arguments, options);
    EXPECT_EQ(outcome.exitCode, exitCode) << outcome.err;
    EXPECT_EQ(outcome.out, "");
    EXPECT_EQ(outcome.err.rfind("medial-viewer: ", 0), 0U) << outcome.err;
    EXPECT_EQ(outcome.err.find('\n'), outcome.err.size() - 1) << outcome.err;
    return outcome.err;
  }

  TemporaryFolder folder;
  std::string input = folder.file("box.obj");
};

RunOptions withDisplay(const std::string& name)
{
  RunOptions options;
  options.environment = { { "DISPLAY", name } };
  return options;
}

TEST_F(ViewerCommand, SaysThatThereIsNoDisplay)
{
  EXPECT_TRUE(contains(failure({ input }, kNoGpu, withDisplay("")), "DISPLAY is not set"));
  EXPECT_TRUE(contains(failure({ input }, kNoGpu, withDisplay(":987")), "DISPLAY=:987"));
}

TEST_F(ViewerCommand, SaysThatTheDisplayHasNoOpenGl)
{
  const VirtualDisplay display({ "-extension", "GLX" });
  EXPECT_TRUE(contains(failure({ input }, kNoGpu), "has no OpenGL"));
}

TEST_F(ViewerCommand, SaysThatTheDisplayWasLost)
{
  VirtualDisplay display;
  std::thread ending(
    [&]
    {
      const std::string search =
        "DISPLAY=" + display.name() + " xdotool search --name '^medial-viewer$' >/dev/null 2>&1";
      for (int i = 0; i < 600 && std::system(search.c_str()) != 0; ++i)
      {
        std::this_thread::sleep_for(std::chrono::milliseconds(100));
      }
      display.end();
    });
  EXPECT_TRUE(contains(failure({ input, "--resolution", "16" }, kNoGpu), "was lost"));
  ending.join();
}

TEST_F(ViewerCommand, RefusesWrongOptions)
{
  EXPECT_TRUE(contains(failure({ input, "--angle", "19.9" }, kUsage), "19.9 is outside [20, 170]"));
  EXPECT_TRUE(
    contains(failure({ input, "--resolution", "257" }, kUsage), "257 is outside [16, 256]"));
  EXPECT_TRUE(contains(failure({ input, "--resolution", "65", "--max-resolution", "64" }, kUsage),
    "[16, 64]"));
  EXPECT_TRUE(contains(failure({ input, "--resolution", "15" }, kUsage), "15 is outside"));
  EXPECT_TRUE(
    contains(failure({ input, "--max-resolution", "31" }, kUsage), "31 is outside [32, 8192]"));
  EXPECT_TRUE(contains(failure({ input, "--colour", "lambda" }, kUsage), "lambda"));
  EXPECT_TRUE(contains(failure({ input, "--screenshot", "a.jpg" }, kUsage), "'.jpg'"));
  EXPECT_TRUE(contains(failure({}, kUsage), "INPUT"));
}

TEST_F(ViewerCommand, RefusesBadInputBeforeItAsksForADisplay)
{
  const std::string bad = folder.file("bad.obj");
  writeFile(bad, "v 0 0 0\nf 1 2 3\n");
  EXPECT_TRUE(contains(failure({ bad }, kBadInput, withDisplay("")), bad));
  EXPECT_TRUE(contains(failure({ folder.file("none.obj") }, kBadInput), "none.obj"));
}

TEST_F(ViewerCommand, SaysThatTheGridIsTooLarge)
{
  const VirtualDisplay display;
  EXPECT_TRUE(contains(
    failure({ input, "--resolution", "8192", "--max-resolution", "8192" }, kNoSpace), "MiB"));
}

TEST_F(ViewerCommand, WritesAScreenshot)
{
  const VirtualDisplay display;
  const std::string file = folder.file("shot.png");
  const Outcome outcome = runMedialViewer({ input, "--resolution", "16", "--screenshot", file });
  EXPECT_EQ(outcome.exitCode, 0) << outcome.err;
  EXPECT_EQ(outcome.err, "");
  EXPECT_EQ(readFile(file).substr(1, 3), "PNG");
}

TEST_F(ViewerCommand, SaysThatAScreenshotCannotBeWritten)
{
  const VirtualDisplay display;
  const std::string file = folder.file("none/shot.png");
  EXPECT_TRUE(
    contains(failure({ input, "--resolution", "16", "--screenshot", file }, kNoSpace), file));
}

TEST_F(ViewerCommand, IsInterrupted)
{
  const VirtualDisplay display;
  RunOptions options;
  options.interruptAfter = 4.0;
  failure({ input, "--resolution", "16" }, kInterrupted, options);
}

} // namespace
} // namespace medial::test
