// medial-measure as a user runs it.
#include "command_run.h"

#include "support/models.h"
#include "support/shapes.h"

#include <filesystem>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace medial::test
{
namespace
{

class MeasureCommand : public ::testing::Test
{
protected:
  MeasureCommand()
  {
    writeFile(mesh, objText(icosphere(1.0, 4)));
    writeFile(ball, "1 0 0\nv 0 0 0 0.9\n");
  }

  // What is measured, in a run that must succeed.
  Json measure(const std::string& axis, const std::string& onMesh,
    std::vector<std::string> arguments = {})
  {
    arguments.insert(arguments.begin(), { axis, onMesh, "--json", folder.file("result.json") });
    const Outcome outcome = runMedialMeasure(arguments);
    EXPECT_EQ(outcome.exitCode, 0) << outcome.err;
    EXPECT_EQ(outcome.err, "");
    return Json::parse(readFile(folder.file("result.json")));
  }

  // A run that must fail with one line and without a file.
  std::string failure(int exitCode, std::vector<std::string> arguments)
  {
    const TemporaryFolder outputs;
    arguments.insert(arguments.end(), { "--json", outputs.file("result.json") });
    const Outcome outcome = runMedialMeasure(arguments);
    EXPECT_EQ(outcome.exitCode, exitCode) << outcome.err;
    EXPECT_EQ(outcome.out, "");
    EXPECT_EQ(outcome.err.rfind("medial-measure: ", 0), 0U) << outcome.err;
    EXPECT_EQ(outcome.err.find('\n'), outcome.err.size() - 1) << outcome.err;
    EXPECT_EQ(outputs.list(), std::vector<std::string>());
    return outcome.err;
  }

  TemporaryFolder folder;
  std::string mesh = folder.file("ball.obj");
  std::string ball = folder.file("ball.ma");
};

TEST_F(MeasureCommand, BallThatIsTooSmall)
{
  const Json result = measure(ball, mesh);
  const double percent = 100.0 / result["mesh"]["diagonal"].get<double>();
  EXPECT_NEAR(result["surface_to_union"]["max"], 0.1 * percent, 1e-6);
  EXPECT_NEAR(result["union_to_surface"]["mean"], 0.1 * percent, 1e-3 * percent);
  EXPECT_NEAR(result["two_sided"]["hausdorff"], 0.1 * percent, 1e-6);
  EXPECT_NEAR(result["two_sided"]["mean"], 0.1 * percent, 1e-3 * percent);
  EXPECT_NEAR(result["radius_error"]["max"], 0.1 * percent, 2e-3 * percent);
  EXPECT_EQ(result["centres_inside"], 1.0);
  EXPECT_EQ(result["axis"]["path"], ball);
  EXPECT_EQ(result["axis"]["points"], 1);
  EXPECT_EQ(result["axis"]["vertices"], 1);
  EXPECT_EQ(result["axis"]["components"], 1);
  EXPECT_EQ(result["axis"]["euler_characteristic"], 1);
  EXPECT_EQ(result["mesh"]["euler_characteristic"], 2);
  EXPECT_EQ(result["mesh"]["closed"], true);
}

TEST_F(MeasureCommand, JsonHasExactlyTheDocumentedKeys)
{
  const Json result = measure(ball, mesh);
  EXPECT_EQ(keysOf(result),
    (std::set<std::string>{ "axis", "mesh", "surface_to_union", "union_to_surface", "two_sided",
      "radius_error", "centres_inside", "seconds" }));
  EXPECT_EQ(keysOf(result["axis"]),
    (std::set<std::string>{ "path", "points", "quads", "triangles", "lines", "vertices",
      "zero_area_cells", "components", "euler_characteristic" }));
  EXPECT_EQ(keysOf(result["mesh"]),
    (std::set<std::string>{ "path", "triangles", "vertices", "closed", "manifold", "components",
      "euler_characteristic", "diagonal" }));
  for (const char* key : { "surface_to_union", "union_to_surface" })
  {
    EXPECT_EQ(keysOf(result[key]), (std::set<std::string>{ "max", "mean", "samples" })) << key;
  }
  EXPECT_EQ(keysOf(result["two_sided"]), (std::set<std::string>{ "hausdorff", "mean" }));
  EXPECT_EQ(keysOf(result["radius_error"]), (std::set<std::string>{ "max", "mean" }));
  EXPECT_EQ(keysOf(result["seconds"]), (std::set<std::string>{ "read", "evaluate" }));
}

TEST_F(MeasureCommand, TableShowsTheFigures)
{
  const Outcome outcome = runMedialMeasure({ ball, mesh });
  EXPECT_EQ(outcome.exitCode, 0);
  EXPECT_EQ(outcome.err, "");
  for (const char* text : { "1 points, 0 quads", "1 component, Euler characteristic 1",
         "5120 triangles, 2562 vertices, closed", "surface to union", "union to surface",
         "two-sided", "radius error", "centres inside the mesh: 100.000 %" })
  {
    EXPECT_TRUE(contains(outcome.out, text)) << text << "\n" << outcome.out;
  }
  const Outcome quiet = runMedialMeasure({ ball, mesh, "-q" });
  EXPECT_EQ(quiet.exitCode, 0);
  EXPECT_EQ(quiet.out, "");
}

TEST_F(MeasureCommand, OpenMeshHasNoInside)
{
  writeFile(mesh, objText(plates(0.5, 1.0)));
  EXPECT_TRUE(measure(ball, mesh)["centres_inside"].is_null());
  EXPECT_TRUE(contains(runMedialMeasure({ ball, mesh }).out, "unknown, it is not closed"));
}

TEST_F(MeasureCommand, SamplesAndThreads)
{
  const Json few = measure(ball, mesh, { "--samples", "2000", "--threads", "1" });
  EXPECT_EQ(few["surface_to_union"]["samples"], 2000);
  const Json again = measure(ball, mesh, { "--samples", "2000", "--threads", "2" });
  for (const char* key : { "surface_to_union", "union_to_surface", "radius_error" })
  {
    EXPECT_EQ(few[key], again[key]) << key;
  }
}

// The axis of a box in every format that medial-axis writes.
TEST_F(MeasureCommand, MeasuresAllThatMedialAxisWrites)
{
  const std::string boxFile = folder.file("box.obj");
  writeFile(boxFile, objText(box({ 1.0, 0.7, 0.4 })));
  Json first;
  for (const char* name : { "axis.vtp", "axis.ply", "axis.obj", "axis.ma" })
  {
    const std::string file = folder.file(name);
    const Outcome outcome =
      runMedialAxis({ boxFile, "--resolution", "41", "--angle", "30", "-q", "-o", file });
    ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
    const Json result = measure(file, boxFile, { "--samples", "20000" });
    EXPECT_LT(result["two_sided"]["hausdorff"], 2.6) << name; // a voxel's diagonal is 3.6
    EXPECT_LT(result["two_sided"]["mean"], 0.2) << name;
    EXPECT_LT(result["radius_error"]["max"], 1e-5) << name;
    EXPECT_EQ(result["centres_inside"], 1.0) << name;
    EXPECT_EQ(result["axis"]["zero_area_cells"], 0) << name;
    EXPECT_EQ(result["axis"]["components"], 1) << name;
    first = first.is_null() ? result : first;
    EXPECT_EQ(result["axis"]["points"], first["axis"]["points"]) << name;
    EXPECT_EQ(result["axis"]["euler_characteristic"], first["axis"]["euler_characteristic"])
      << name;
    EXPECT_NEAR(result["surface_to_union"]["mean"], first["surface_to_union"]["mean"], 1e-9)
      << name;
    EXPECT_NEAR(result["union_to_surface"]["max"], first["union_to_surface"]["max"], 1e-3) << name;
  }
  EXPECT_GT(first["axis"]["quads"], 100);
}

TEST_F(MeasureCommand, HelpNamesEveryOption)
{
  const Outcome help = runMedialMeasure({ "--help" });
  EXPECT_EQ(help.exitCode, 0);
  EXPECT_EQ(help.err, "");
  for (const char* text : { "AXIS", "MESH", "--json", "--samples", "--threads", "-q,--quiet",
         "--version", "--help", "[1000, 100000000]", "default 100000", "Exit codes" })
  {
    EXPECT_TRUE(contains(help.out, text)) << text;
  }
  std::istringstream lines(help.out);
  for (std::string line; std::getline(lines, line);)
  {
    EXPECT_LE(line.size(), 100U) << line;
  }
  EXPECT_TRUE(contains(runMedialMeasure({ "--version" }).out, "medial-measure "));
}

TEST_F(MeasureCommand, UsageErrors)
{
  EXPECT_TRUE(contains(failure(kUsage, { ball, mesh, "--samples", "999" }),
    "999 is outside [1000, 100000000]"));
  EXPECT_TRUE(contains(failure(kUsage, { ball, mesh, "--threads", "-1" }), "-1 is outside"));
  EXPECT_TRUE(contains(failure(kUsage, { ball, mesh, "--colour" }), "--colour"));
  EXPECT_TRUE(contains(failure(kUsage, { ball }), "MESH"));
  const Outcome outcome = runMedialMeasure({ ball, mesh, "--json", folder.file("result.txt") });
  EXPECT_EQ(outcome.exitCode, kUsage);
  EXPECT_TRUE(contains(outcome.err, "'.txt', allowed: .json")) << outcome.err;
}

TEST_F(MeasureCommand, BadFilesAreNamed)
{
  EXPECT_TRUE(contains(failure(kBadInput, { folder.file("no.ma"), mesh }), "no.ma: no such file"));
  EXPECT_TRUE(
    contains(failure(kBadInput, { ball, folder.file("no.obj") }), "no.obj: no such file"));
  writeFile(ball, "2 0 0\nv 0 0 0 1\n");
  EXPECT_TRUE(contains(failure(kBadInput, { ball, mesh }), ball + ": ends early or is damaged"));
  writeFile(ball, "1 0 0\nv 0 0 0 -1\n");
  EXPECT_TRUE(contains(failure(kBadInput, { ball, mesh }), ball + ": line 2: radius '-1'"));
  writeFile(ball, "1 0 0\nv 0 0 0 1\n");
  writeFile(mesh, "v 0 0 0\nv 1 0 0\nl 1 2\n");
  EXPECT_TRUE(contains(failure(kBadInput, { ball, mesh }), mesh + ": the mesh has an area of 0"));
  writeFile(mesh, "v 0 0 nan\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  EXPECT_TRUE(contains(failure(kBadInput, { ball, mesh }), mesh + ": "));
}

TEST_F(MeasureCommand, JsonOnStandardOutputIsThatOfTheFile)
{
  const std::string file = folder.file("result.json");
  EXPECT_EQ(runMedialMeasure({ ball, mesh, "--json", file, "-q" }).exitCode, 0);
  Json written = Json::parse(readFile(file));
  const Outcome outcome = runMedialMeasure({ ball, mesh, "--json", "-" });
  EXPECT_EQ(outcome.exitCode, 0) << outcome.err;
  Json printed = Json::parse(outcome.out);
  written.erase("seconds");
  printed.erase("seconds");
  EXPECT_EQ(printed, written);
  EXPECT_FALSE(std::filesystem::exists("-"));
}

TEST_F(MeasureCommand, OutputThatCannotBeWritten)
{
  const std::string file = folder.file("no/such/folder/result.json");
  const Outcome outcome = runMedialMeasure({ ball, mesh, "--json", file });
  EXPECT_EQ(outcome.exitCode, kNoSpace);
  EXPECT_TRUE(contains(outcome.err, file + ": cannot be written")) << outcome.err;
  RunOptions full;
  full.fileSizeLimit = 64;
  writeFile(folder.file("old.json"), "old");
  const Outcome cut =
    runMedialMeasure({ ball, mesh, "-q", "--json", folder.file("old.json") }, full);
  EXPECT_EQ(cut.exitCode, kNoSpace);
  EXPECT_EQ(readFile(folder.file("old.json")), "old");
}

TEST_F(MeasureCommand, InterruptLeavesNothingBehind)
{
  RunOptions options;
  options.interruptAfter = 0.4;
  const Outcome outcome = runMedialMeasure(
    { ball, mesh, "--samples", "20000000", "--json", folder.file("result.json") }, options);
  EXPECT_EQ(outcome.exitCode, kInterrupted) << outcome.err;
  EXPECT_TRUE(contains(outcome.err, "interrupted")) << outcome.err;
  EXPECT_EQ(folder.list(), (std::vector<std::string>{ "ball.ma", "ball.obj" }));
}

// An axis that others have published, where there is one; a ball otherwise.
TEST_F(MeasureCommand, PublishedAxis)
{
  const auto axis = modelPath("ma_ref/camila_hand_v200.ma");
  const auto hand = modelPath("ma_ref/camila_hand.off");
  if (!axis || !hand)
  {
    EXPECT_EQ(measure(ball, mesh)["axis"]["points"], 1);
    return;
  }
  const Json result = measure(*axis, *hand, { "--samples", "20000" });
  EXPECT_EQ(result["axis"]["points"], 200);
  EXPECT_EQ(result["axis"]["triangles"], 201);
  EXPECT_EQ(result["axis"]["components"], 1);
  EXPECT_LT(result["two_sided"]["hausdorff"], 3.0);
  EXPECT_GT(result["two_sided"]["hausdorff"], 0.3);
}

} // namespace
} // namespace medial::test
