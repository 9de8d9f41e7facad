#include "program.h"
#include "scan_files.h"
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

  // A ball with the label 2.
  std::string writeScan() const
  {
    writeFile(folder.file("ball.nrrd"),
      nrrdFile(LabelImage([](double r) { return r < 4.0 ? 2 : 0; }), "gzip"));
    return folder.file("ball.nrrd");
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

TEST_F(ViewerCommand, RefusesScansAndMeshesThatDoNotFitTheirOptions)
{
  const std::string scan = writeScan();
  EXPECT_TRUE(contains(failure({ scan }, kUsage),
    scan + " is an image: choose its surface with --isovalue V or --label N"));
  EXPECT_TRUE(contains(failure({ scan, "--label", "1", "--isovalue", "1" }, kUsage),
    "--isovalue 1 cannot be given together with --label 1"));
  EXPECT_TRUE(contains(failure({ input, "--label", "1" }, kUsage),
    "--label needs an image (.nrrd .mha .mhd .nii .nii.gz .vti), which " + input + " is not"));
  EXPECT_TRUE(contains(failure({ input, "--isovalue", "1" }, kUsage), "--isovalue needs an image"));
  EXPECT_TRUE(contains(failure({ input, "--scan-smoothing", "1" }, kUsage),
    "--scan-smoothing needs an image"));
  EXPECT_TRUE(contains(failure({ scan, input, "--label", "2" }, kUsage), input + " is not"));
  EXPECT_TRUE(contains(failure({ folder.path(), "--label", "2" }, kUsage), "needs an image"));
}

TEST_F(ViewerCommand, RefusesSurfacesThatAScanDoesNotHaveBeforeItAsksForADisplay)
{
  const std::string scan = writeScan();
  EXPECT_TRUE(contains(failure({ scan, "--label", "5" }, kBadInput, withDisplay("")),
    scan + ": has no voxel with the label 5; those that occur: 0, 2"));
  EXPECT_TRUE(contains(failure({ scan, "--isovalue", "5" }, kBadInput, withDisplay("")),
    "has no surface at the isovalue 5: its values are in [0, 2]"));
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

TEST_F(ViewerCommand, WritesAScreenshotOfAScan)
{
  const VirtualDisplay display;
  const std::string file = folder.file("shot.png");
  const Outcome outcome =
    runMedialViewer({ writeScan(), "--label", "2", "--resolution", "16", "--screenshot", file });
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
