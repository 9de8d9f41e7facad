#include "program.h"
#include "support/mesh_texts.h"

#include "support/shapes.h"

#include <vtkMedialAxis.h>
#include <vtkNew.h>

#include <gtest/gtest.h>

#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace medial::test
{
namespace
{

class CommandLine : public ::testing::Test
{
protected:
  CommandLine() { writeFile(input, objText(box({ 1.0, 0.7, 0.4 }))); }

  // Runs with arguments that must be refused as usage errors; returns the one line on stderr.
  std::string usageError(std::vector<std::string> arguments)
  {
    arguments.insert(arguments.begin(), { input, "-o", folder.file("axis.vtp") });
    const Outcome outcome = runMedialAxis(arguments);
    EXPECT_EQ(outcome.exitCode, kUsage) << outcome.err;
    EXPECT_EQ(outcome.out, "");
    EXPECT_EQ(outcome.err.find('\n'), outcome.err.size() - 1) << outcome.err;
    EXPECT_EQ(folder.list(), std::vector<std::string>{ "box.obj" });
    return outcome.err;
  }

  TemporaryFolder folder;
  std::string input = folder.file("box.obj");
};

// The words of a text with one space between them.
std::string onOneLine(const std::string& text)
{
  std::istringstream words(text);
  std::string line;
  for (std::string word; words >> word;)
  {
    line += word + ' ';
  }
  return line;
}

std::string defaultOf(double value)
{
  std::ostringstream text;
  text << "default " << value;
  return text.str();
}

TEST_F(CommandLine, HelpNamesEveryOption)
{
  const Outcome help = runMedialAxis({ "--help" });
  EXPECT_EQ(help.exitCode, 0);
  EXPECT_EQ(help.err, "");
  for (const char* option :
    { "-o,--output", "--curves", "--field", "--local-thickness", "--histogram", "--band",
      "--isovalue", "--label", "--scan-smoothing", "--skeleton", "--skeleton-table", "--min-branch",
      "--no-smooth", "--thickness", "--thickness-image", "--thin-regions", "--thickness-method",
      "--min-thickness", "--max-thickness", "--max-edge", "--image", "--resolution", "--spacing",
      "--padding", "--angle", "--lambda", "--min-radius", "--side", "--representation",
      "--max-spheres", "--topology", "--sign", "--threads", "--memory", "--report", "--device",
      "--list-devices", "--require-gpu", "-q,--quiet", "--version", "--help" })
  {
    EXPECT_TRUE(contains(help.out, option)) << option;
  }
  std::istringstream lines(help.out);
  for (std::string line; std::getline(lines, line);)
  {
    EXPECT_LE(line.size(), 100U) << line;
  }
  EXPECT_TRUE(contains(help.out,
    "Exit codes: 0 done; 1 done, but the thickness is beyond its limits; 2 usage; 3 bad input;"));
}

TEST_F(CommandLine, HelpStatesTheDefaultsOfTheFilter)
{
  const std::string help = onOneLine(runMedialAxis({ "--help" }).out);
  vtkNew<vtkMedialAxis> filter;
  EXPECT_TRUE(contains(help, "in [2, 8192]; " + defaultOf(filter->GetResolution())));
  EXPECT_TRUE(contains(help, "in [0, 10]; " + defaultOf(filter->GetPadding())));
  EXPECT_TRUE(contains(help, defaultOf(filter->GetAngle())));
  EXPECT_TRUE(contains(help, "0 for no limit; " + defaultOf(filter->GetMaximumNumberOfSpheres())));
  EXPECT_TRUE(contains(help, "0 for all cores; " + defaultOf(filter->GetNumberOfThreads())));
  EXPECT_TRUE(contains(help, "0 chooses one; " + defaultOf(filter->GetMemoryLimit())));
}

TEST_F(CommandLine, ListsDevicesWithoutAMesh)
{
  const Outcome list = runMedialAxis({ "--list-devices" });
  EXPECT_EQ(list.exitCode, 0) << list.err;
  EXPECT_EQ(list.out.rfind("0  ", 0), 0U) << list.out;
}

TEST_F(CommandLine, VersionIsOneLine)
{
  const Outcome version = runMedialAxis({ "--version" });
  EXPECT_EQ(version.exitCode, 0);
  EXPECT_EQ(version.out.rfind("medial-axis ", 0), 0U);
  EXPECT_EQ(version.out.find('\n'), version.out.size() - 1);
}

TEST_F(CommandLine, RefusesNumbersOutsideTheirRange)
{
  const std::vector<std::array<std::string, 3>> cases = { { "--resolution", "0", "[2, 8192]" },
    { "--resolution", "100000", "[2, 8192]" }, { "--resolution", "1.5", "[2, 8192]" },
    { "--spacing", "-0.5", "(0, infinity)" }, { "--spacing", "0", "(0, infinity)" },
    { "--spacing", "nan", "(0, infinity)" }, { "--padding", "-1", "[0, 10]" },
    { "--padding", "11", "[0, 10]" }, { "--angle", "0", "(0, 180)" },
    { "--angle", "180", "(0, 180)" }, { "--angle", "-3", "(0, 180)" },
    { "--angle", "nan", "(0, 180)" }, { "--angle", "wide", "(0, 180)" },
    { "--max-spheres", "-1", "[0, 2147483647]" }, { "--max-spheres", "2.5", "[0, 2147483647]" },
    { "--threads", "-1", "[0, 1024]" }, { "--threads", "2000", "[0, 1024]" },
    { "--memory", "63", "[64," }, { "--memory", "-64", "[64," } };
  for (const auto& [option, value, range] : cases)
  {
    const std::string error = usageError({ option, value });
    EXPECT_TRUE(contains(error, option)) << error;
    EXPECT_TRUE(contains(error, value)) << error;
    EXPECT_TRUE(contains(error, range)) << error;
  }
}

TEST_F(CommandLine, RefusesUnknownWords)
{
  EXPECT_TRUE(
    contains(usageError({ "--side", "top" }), "'top' is not one of both, exterior, interior"));
  EXPECT_TRUE(contains(usageError({ "--representation", "mesh" }),
    "'mesh' is not one of faces, points, surface"));
  EXPECT_TRUE(
    contains(usageError({ "--topology", "genus" }), "'genus' is not one of preserve, selected"));
  EXPECT_TRUE(contains(usageError({ "--topology", "preserve", "--representation", "points" }),
    "--topology preserve needs --representation surface or faces"));
  EXPECT_TRUE(contains(usageError({ "--sign", "plus" }), "'plus' is not one of"));
  EXPECT_TRUE(contains(usageError({ "--colour", "red" }), "--colour"));
  EXPECT_TRUE(contains(usageError({ "second.obj" }), "second.obj"));
}

TEST_F(CommandLine, WhatIsNoNumberIsRefused)
{
  EXPECT_TRUE(
    contains(usageError({ "--angle", "60deg" }), "60deg is not a number; allowed: (0, 180)"));
  EXPECT_TRUE(
    contains(usageError({ "--resolution", "1.5" }), "1.5 is not a whole number; allowed: [2, "));
}

TEST_F(CommandLine, RefusesUnknownOutputFormats)
{
  EXPECT_TRUE(contains(usageError({ "--field", folder.file("x.vtk") }), "x.vtk"));
  EXPECT_TRUE(contains(usageError({ "--image", folder.file("x.jpg") }), "'.jpg', allowed: .png"));
  EXPECT_TRUE(contains(usageError({ "--report", folder.file("x") }), "allowed: .json"));
  EXPECT_TRUE(
    contains(usageError({ "--thickness", folder.file("x.stl") }), "'.stl', allowed: .vtp"));
  EXPECT_TRUE(contains(usageError({ "--thickness-image", folder.file("x.jpg") }), "allowed: .png"));
  EXPECT_TRUE(contains(
    usageError({ "--local-thickness", folder.file("x.vti"), "--histogram", folder.file("x.svg") }),
    "allowed: .png"));
  const Outcome outcome = runMedialAxis({ input, "-o", folder.file("axis.stl") });
  EXPECT_EQ(outcome.exitCode, kUsage);
  EXPECT_TRUE(contains(outcome.err, "'.stl', allowed: .vtp .pvtp .ply .obj .ma")) << outcome.err;
}

TEST_F(CommandLine, RefusesSignMethodsThatItDoesNotHave)
{
  const std::string error = usageError({ "--sign", "parity" });
  EXPECT_TRUE(contains(error, "parity") && contains(error, "auto, none, pseudonormal, winding"))
    << error;
}

TEST_F(CommandLine, RefusesToSimplifyPoints)
{
  const std::string error = usageError({ "--max-spheres", "20", "--representation", "points" });
  EXPECT_TRUE(contains(error, "--max-spheres 20") && contains(error, "surface or faces")) << error;
}

TEST_F(CommandLine, RefusesTwoGridsAtOnce)
{
  const std::string error = usageError({ "--resolution", "32", "--spacing", "0.1" });
  EXPECT_TRUE(contains(error, "--resolution 32 cannot be given together with --spacing 0.1"))
    << error;
}

TEST_F(CommandLine, SaysWhatAnOptionNeeds)
{
  const std::string error = usageError({ "--band", "3" });
  EXPECT_TRUE(contains(error, "--band 3 needs --field (see")) << error;
}

// As variables of a shell are that were never set.
TEST_F(CommandLine, RefusesEmptyValues)
{
  for (const char* option : { "--thickness", "--field", "--report", "--device" })
  {
    EXPECT_TRUE(contains(usageError({ option, "" }),
      std::string(option) + " needs a value, not an empty one (see medial-axis --help)"));
  }
  EXPECT_TRUE(contains(usageError({ "--field", folder.file("f.vti"), "--field-arrays", "" }),
    "--field-arrays needs a value"));
  const auto refused = [](const Outcome& outcome, const std::string& option)
  {
    EXPECT_EQ(outcome.exitCode, kUsage);
    EXPECT_TRUE(contains(outcome.err, option + " needs a value, not an empty one")) << outcome.err;
    EXPECT_EQ(outcome.out, "");
  };
  refused(runMedialAxis({ "" }), "INPUT");
  refused(runMedialAxis({ input, "-o", "" }), "--output");
  refused(runMedialAxis({ input, "--output=", folder.file("a.vtp") }), "--output");
  refused(runMedialDistance({ input, input, "-q", "-o", "" }), "--output");
  refused(runMedialMeasure({ input, input, "--json", "" }), "--json");
  refused(runMedialProximity({ input, input, "--transform", "" }), "--transform");
  refused(runMedialViewer({ input, "--screenshot", "" }), "--screenshot");
}

TEST_F(CommandLine, RefusesTwoOutputsOfOneName)
{
  EXPECT_TRUE(contains(usageError({ "--thickness", folder.file("axis.vtp") }),
    "--output and --thickness name the same file"));
  EXPECT_TRUE(contains(usageError({ "--image", folder.file("x.png"), "--thickness-image",
                         (folder.path() / "." / "x.png").string() }),
    "--image and --thickness-image name the same file"));
  EXPECT_TRUE(contains(usageError({ "--image", folder.file("x.png"), "--local-thickness",
                         folder.file("x.vti"), "--histogram", folder.file("x.png") }),
    "--histogram and --image name the same file"));
}

TEST_F(CommandLine, NamesWhatItDoesNotExpect)
{
  EXPECT_TRUE(contains(usageError({ "--zebra", "5" }), "unknown option --zebra (see"));
  EXPECT_TRUE(contains(usageError({ "b.ply", "c.ply" }), "unexpected argument 'b.ply'"));
  EXPECT_TRUE(contains(runMedialAxis({ "--resolutoin", "5" }).err, "--resolutoin"));
  EXPECT_TRUE(contains(usageError({ "--resolution" }), "--resolution needs a value"));
  EXPECT_TRUE(contains(usageError({ "--resolution", "5", "--resolution", "6" }),
    "--resolution may be given only once"));
}

TEST_F(CommandLine, SuggestsTheOptionThatWasMeant)
{
  const std::vector<std::pair<const char*, const char*>> meant = { { "--resolutoin", "resolution" },
    { "--resolutions", "resolution" }, { "-resolution=64", "resolution" },
    { "--min-thicknes", "min-thickness" }, { "--thicknes-image", "thickness-image" },
    { "--rep", "" }, { "--repo", "report" }, { "--", "" }, { "---", "" }, { "--=", "" },
    { "-z", "" }, { "--colour", "" } };
  for (const auto& [typed, option] : meant)
  {
    const std::string error = usageError({ typed, "5" });
    const std::string question = std::string("did you mean --") + option + "?";
    EXPECT_EQ(contains(error, *option != 0 ? question : "did you mean"), *option != 0) << error;
  }
}

TEST_F(CommandLine, NeedsAnInput)
{
  const Outcome outcome = runMedialAxis({});
  EXPECT_EQ(outcome.exitCode, kUsage);
  EXPECT_TRUE(contains(outcome.err, "INPUT")) << outcome.err;
}

TEST_F(CommandLine, DoesNotOverwriteItsInput)
{
  const std::string before = readFile(input);
  const Outcome outcome = runMedialAxis({ input, "-o", folder.path() / "." / "box.obj" });
  EXPECT_EQ(outcome.exitCode, kUsage) << outcome.err;
  EXPECT_EQ(readFile(input), before);
}

} // namespace
} // namespace medial::test
