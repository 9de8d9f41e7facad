// The reports and notes of medial-axis, and the effect of its options on the axis.
#include "command_output.h"

#include "support/transforms.h"

#include "medial/version.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <set>

namespace medial::test
{
namespace
{

double sumOfPhases(const Json& seconds)
{
  double sum = 0.0;
  for (const auto& item : seconds.items())
  {
    sum += item.key() == "total" ? 0.0 : item.value().get<double>();
  }
  return sum;
}

TEST_F(CommandOutput, ReportHasExactlyTheDocumentedKeys)
{
  const Json result = report({});
  EXPECT_EQ(keysOf(result),
    (std::set<std::string>{ "version", "parameters", "side", "input", "grid", "device", "seconds",
      "counts", "fragments_per_voxel", "device_seconds", "bytes_uploaded", "bytes_read_back",
      "dispatches", "simplification", "engine", "sign", "sign_method", "topology", "coverage",
      "peak_memory_mib", "ranks" }));
  EXPECT_EQ(keysOf(result["coverage"]),
    (std::set<std::string>{ "places", "spacing", "uncovered_share", "reach", "samples",
      "seconds" }));
  EXPECT_EQ(keysOf(result["simplification"]),
    (std::set<std::string>{ "input_points", "input_components", "components", "joined", "forced",
      "dropped", "seconds" }));
  EXPECT_EQ(keysOf(result["input"]),
    (std::set<std::string>{ "path", "triangles", "vertices", "closed", "manifold", "components",
      "skipped_degenerate" }));
  EXPECT_EQ(keysOf(result["grid"]), (std::set<std::string>{ "dimensions", "spacing", "origin" }));
  EXPECT_EQ(keysOf(result["device"]),
    (std::set<std::string>{ "number", "origin", "renderer", "version", "software" }));
  EXPECT_EQ(keysOf(result["seconds"]),
    (std::set<std::string>{ "read", "prepare", "sites", "sign", "cull", "polygons", "draw",
      "resolve", "medial", "measure", "skeleton", "thickness", "pictures", "write", "total" }));
  EXPECT_EQ(keysOf(result["counts"]),
    (std::set<std::string>{ "sites", "polygons", "fragments", "group_tests", "site_tests",
      "candidate_pairs", "medial_points", "medial_cells" }));
}

TEST_F(CommandOutput, ReportHasVersionAndParameters)
{
  const Json result = report({ "--angle", "75", "--lambda", "2%", "--side", "exterior" });
  EXPECT_EQ(result["version"], MEDIAL_VERSION);
  EXPECT_EQ(result["parameters"]["angle"], 75.0);
  const double diagonal = 2.0 * std::sqrt(1.0 + 0.49 + 0.16);
  EXPECT_NEAR(result["parameters"]["lambda"].get<double>(), 0.02 * diagonal, 1e-6);
  EXPECT_EQ(result["parameters"]["side"], "exterior");
  EXPECT_EQ(result["side"], "exterior");
}

// Without a grid there is neither a sign nor an engine to report.
TEST_F(CommandOutput, ReportOfThicknessAloneHasNoFigureOfAField)
{
  const Json result = report({ "--thickness", folder.file("thickness.vtp") });
  for (const char* key : { "grid", "sign", "sign_method", "side", "engine", "topology" })
  {
    EXPECT_TRUE(result[key].is_null()) << key << ": " << result[key];
  }
  EXPECT_EQ(result["thickness"]["side"], "interior");
  EXPECT_GT(result["seconds"]["thickness"].get<double>(), 0.0);
}

// A cup without its bottom: the box of the other tests without its first side.
TEST_F(CommandOutput, SaysThatASideIsNotThereEvenWhenQuiet)
{
  TriangleMesh cup = box({ 1.0, 0.7, 0.4 });
  cup.triangles.erase(cup.triangles.begin(), cup.triangles.begin() + 2);
  writeFile(input, objText(cup));
  const std::string file = folder.file("axis.vtp");
  const Outcome asked = run({ "-q", "-o", file, "--side", "interior" });
  EXPECT_TRUE(contains(asked.err, "axis is that of both sides; --sign winding")) << asked.err;
  EXPECT_EQ(run({ "-q", "-o", file }).err, "");
  EXPECT_EQ(run({ "-q", "-o", file, "--side", "both" }).err, "");
  EXPECT_EQ(run({ "-q", "-o", file, "--side", "interior", "--sign", "winding" }).err, "");
  EXPECT_EQ(report({ "--sign", "winding" })["side"], "interior");
}

TEST_F(CommandOutput, ReportGoesToStandardOutputAlone)
{
  const Outcome outcome = run({ "--report", "-", "-o", folder.file("axis.vtp") });
  EXPECT_EQ(nlohmann::json::parse(outcome.out)["version"], MEDIAL_VERSION);
  EXPECT_FALSE(std::filesystem::exists("-"));
  const Outcome quiet = run({ "-q", "--report", "-", "-o", folder.file("axis.vtp") });
  EXPECT_EQ(nlohmann::json::parse(quiet.out)["parameters"]["angle"], 60.0);
}

// Whoever asks where the time went finds it.
TEST_F(CommandOutput, PhasesAddUpToTheTotal)
{
  const Json seconds = report({ "-o", folder.file("axis.vtp"), "--thickness",
    folder.file("thickness.vtp"), "--thickness-image", folder.file("thickness.png"), "--image",
    folder.file("axis.png"), "--max-spheres", "20" })["seconds"];
  EXPECT_GT(sumOfPhases(seconds), 0.8 * seconds["total"].get<double>()) << seconds;
  EXPECT_GT(seconds["pictures"].get<double>(), 0.0);
  EXPECT_GT(seconds["measure"].get<double>(), 0.0);
}

// A mesh of many triangles on a coarse grid: what is made of its elements takes most of the time.
// (The rasteriser's phases are those of the device's clock.)
TEST_F(CommandOutput, NoTimeCountsInTwoPhases)
{
  writeFile(input, objText(icosphere(1.0, 6)));
  const Json seconds =
    report({ "-o", folder.file("axis.vtp"), "--engine", "processor" })["seconds"];
  EXPECT_LE(sumOfPhases(seconds), seconds["total"].get<double>()) << seconds;
}

TEST_F(CommandOutput, ReportsTheTopology)
{
  const std::set<std::string> keys{ "components", "euler_characteristic", "genus", "cavities" };
  writeFile(input, objText(torus(1.0, 0.3, 24, 12)));
  const Json selected = report({ "--angle", "150" })["topology"];
  EXPECT_EQ(keysOf(selected), (std::set<std::string>{ "mode", "solid", "axis" }));
  EXPECT_EQ(selected["mode"], "selected");
  EXPECT_TRUE(selected["solid"].is_null());
  EXPECT_EQ(keysOf(selected["axis"]), keys);
  EXPECT_GT(selected["axis"]["components"], 1);
  const Json preserved = report({ "--angle", "150", "--topology", "preserve" })["topology"];
  EXPECT_EQ(preserved["mode"], "preserve");
  EXPECT_EQ(keysOf(preserved["solid"]), keys);
  EXPECT_EQ(preserved["solid"], preserved["axis"]);
  EXPECT_EQ(preserved["axis"]["components"], 1);
  EXPECT_EQ(preserved["axis"]["euler_characteristic"], 0);
  EXPECT_EQ(preserved["axis"]["genus"], 1);
  EXPECT_EQ(preserved["axis"]["cavities"], 0);
}

TEST_F(CommandOutput, ReportIsPlausible)
{
  const Json result = report({ "-o", folder.file("axis.vtp") });
  EXPECT_EQ(result["input"]["path"], input);
  EXPECT_EQ(result["input"]["triangles"], 12);
  EXPECT_EQ(result["input"]["vertices"], 8);
  EXPECT_EQ(result["input"]["closed"], true);
  EXPECT_EQ(result["input"]["manifold"], true);
  EXPECT_EQ(result["input"]["components"], 1);
  EXPECT_EQ(result["input"]["skipped_degenerate"], 0);
  EXPECT_EQ(result["grid"]["dimensions"][0], kResolution);
  EXPECT_EQ(result["sign_method"], "winding");
  EXPECT_EQ(result["counts"]["sites"], 12 + 18 + 8);
  EXPECT_EQ(result["counts"]["medial_points"],
    readVtp(folder.file("axis.vtp"))->GetNumberOfPoints());
  EXPECT_EQ(result["engine"], "processor");
  EXPECT_TRUE(result["device"]["renderer"].is_null());
  EXPECT_GE(result["fragments_per_voxel"].get<double>(), 1.0);
  EXPECT_GT(result["peak_memory_mib"].get<double>(), 1.0);
  for (const auto& item : result["seconds"].items())
  {
    EXPECT_GE(item.value().get<double>(), 0.0) << item.key();
  }
  const double sum = sumOfPhases(result["seconds"]);
  EXPECT_LE(sum, result["seconds"]["total"].get<double>() * 1.01);
  EXPECT_GT(sum, 0.0);
}

TEST_F(CommandOutput, SaysWhichEngineRanAndOnWhat)
{
  const std::string file = folder.file("axis.vtp");
  const Outcome processor = run({ "-o", file, "--engine", "processor" });
  EXPECT_TRUE(contains(processor.out, "\nengine    processor\n")) << processor.out;
  const std::string report = folder.file("report.json");
  for (const std::string engine : { "rasteriser", "device" })
  {
    const Outcome drawn = run({ "-o", file, "--engine", engine, "--report", report });
    const auto device = nlohmann::json::parse(readFile(report))["device"];
    const std::string expected = "\nengine    " + engine + " on " +
      device["renderer"].get<std::string>() + (device["software"].get<bool>() ? " (software)" : "");
    EXPECT_TRUE(contains(drawn.out, expected + "\n")) << drawn.out;
  }
}

TEST_F(CommandOutput, SaysWhatItDidUnlessQuiet)
{
  const std::string file = folder.file("axis.vtp");
  const Outcome loud = run({ "-o", file });
  for (const std::string& part : { input + ": 12 triangles, 8 vertices, 1 component, closed",
         std::string("\nengine    "), std::string("\nseconds   "), file + ": medial axis" })
  {
    EXPECT_TRUE(contains(loud.out, part)) << loud.out;
  }
  EXPECT_EQ(loud.err, "");
  const Outcome quiet = run({ "-o", file, "--quiet" });
  EXPECT_EQ(quiet.out + quiet.err, "");
}

TEST_F(CommandOutput, SpacingAndPaddingMakeTheGrid)
{
  const Json grid = report({ "--spacing", "0.1", "--padding", "0.5" })["grid"];
  EXPECT_DOUBLE_EQ(grid["spacing"][1].get<double>(), 0.1);
  const double diagonal = 2.0 * std::sqrt(1.0 + 0.49 + 0.16);
  EXPECT_NEAR(grid["origin"][0].get<double>(), -1.0 - 0.5 * diagonal, 0.1);
}

TEST_F(CommandOutput, AngleDropsTheEdgeSheets)
{
  const auto whole = axis({ "--angle", "60" });
  const auto flat = axis({ "--angle", "120" });
  EXPECT_LT(flat->GetNumberOfPoints(), whole->GetNumberOfPoints() / 2);
  for (vtkIdType i = 0; i < flat->GetNumberOfPoints(); ++i)
  {
    ASSERT_NEAR(flat->GetPoint(i)[2], 0.0, 0.5 * kSpacing);
  }
}

TEST_F(CommandOutput, MaxSpheresMakesTheAxisCompact)
{
  const std::string ma = folder.file("axis.ma");
  const Json result = report({ "--max-spheres", "24", "-o", ma });
  EXPECT_EQ(readFile(ma).substr(0, 3), "24 ");
  EXPECT_EQ(result["counts"]["medial_points"], 24);
  const Json& simplification = result["simplification"];
  EXPECT_GT(simplification["input_points"], 1000);
  EXPECT_EQ(simplification["components"], 1);
  EXPECT_EQ(simplification["dropped"], 0);
  const auto compact = axis({ "--max-spheres", "24" });
  std::set<int> corners; // of the box, where the sheets end
  for (vtkIdType i = 0; i < compact->GetNumberOfPoints(); ++i)
  {
    const double* p = compact->GetPoint(i);
    const double radius = radiusAt(compact, i);
    ASSERT_NEAR(radius, exactRadius(p), 0.2 * kSpacing);
    const bool atCorner = std::abs(p[0]) > 0.9 && std::abs(p[1]) > 0.6 && std::abs(p[2]) > 0.3;
    corners.insert(atCorner ? (p[0] > 0.0) + 2 * (p[1] > 0.0) + 4 * (p[2] > 0.0) : -1);
  }
  corners.erase(-1);
  EXPECT_EQ(corners.size(), 8U);
}

TEST_F(CommandOutput, SaysWhichComponentsMaxSpheresLeavesOut)
{
  const TriangleMesh one = box(kHalfSides);
  writeFile(input, objText(appended(one, translated(scaled(one, 0.5), { 3.0, 0.0, 0.0 }))));
  const Outcome outcome = run({ "--max-spheres", "1", "-o", folder.file("axis.vtp") });
  EXPECT_TRUE(contains(outcome.err,
    "--max-spheres 1 is below the number of components of the axis, 2; the 1 smallest"))
    << outcome.err;
  const auto left = readVtp(folder.file("axis.vtp"));
  ASSERT_EQ(left->GetNumberOfPoints(), 1);
  EXPECT_LT(left->GetPoint(0)[0], 1.0);
  EXPECT_EQ(
    axis({ "--max-spheres", "1", "--side", "exterior", "--angle", "170" })->GetNumberOfPolys(), 0);
}

TEST_F(CommandOutput, RepresentationsDiffer)
{
  EXPECT_EQ(axis({ "--representation", "points" })->GetNumberOfPolys(), 0);
  const auto faces = axis({ "--representation", "faces" });
  ASSERT_GT(faces->GetNumberOfPolys(), 100);
  for (vtkIdType i = 0; i < faces->GetNumberOfPolys(); ++i)
  {
    double bounds[6];
    faces->GetCellBounds(i, bounds);
    const int flat = (bounds[1] == bounds[0]) + (bounds[3] == bounds[2]) + (bounds[5] == bounds[4]);
    ASSERT_EQ(flat, 1);
  }
}

TEST_F(CommandOutput, AConvexShapeHasNoExteriorAxis)
{
  const Outcome outcome = run({ "--side", "exterior", "-o", folder.file("axis.vtp") });
  EXPECT_EQ(readVtp(folder.file("axis.vtp"))->GetNumberOfPoints(), 0);
  EXPECT_TRUE(contains(outcome.err, "60 degrees or more")) << outcome.err;
  EXPECT_TRUE(
    contains(run({ "--lambda", "50%", "--min-radius", "10", "-o", folder.file("axis.vtp") }).err,
      "60 degrees and a lambda of 50 % and a radius of 10 or more"));
  run({ "--side", "exterior", "--image", folder.file("picture.png") });
  run({ "--side", "exterior", "-o", folder.file("axis.ma") });
  EXPECT_EQ(readFile(folder.file("axis.ma")), "0 0 0\n");
}

TEST_F(CommandOutput, AnOpenMeshGivesBothSidesAndANote)
{
  writeFile(input, objText(plates(0.6, 1.0)));
  const Outcome outcome = run({ "-o", folder.file("axis.vtp"), "--report", folder.file("r.json") });
  EXPECT_TRUE(contains(outcome.err,
    "the mesh does not define an inside: its winding number is between 1/4 and 3/4"))
    << outcome.err;
  EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1);
  EXPECT_GT(readVtp(folder.file("axis.vtp"))->GetNumberOfPolys(), 0);
  const Json result = Json::parse(readFile(folder.file("r.json")));
  EXPECT_EQ(result["sign_method"], "none");
  EXPECT_EQ(result["input"]["closed"], false);
  EXPECT_EQ(run({ "--side", "both", "-o", folder.file("axis.vtp") }).err, "");
}

TEST_F(CommandOutput, AMisorientedMeshIsTurnedAndGivesTheInterior)
{
  TriangleMesh mesh = box(kHalfSides);
  std::swap(mesh.triangles[4][0], mesh.triangles[4][1]);
  writeFile(input, objText(mesh));
  const Outcome outcome = run({ "-o", folder.file("axis.vtp"), "--report", folder.file("r.json") });
  EXPECT_EQ(outcome.err, "");
  const Json result = Json::parse(readFile(folder.file("r.json")));
  EXPECT_EQ(result["sign_method"], "winding");
  EXPECT_EQ(result["sign"]["turned"], 1);
  EXPECT_EQ(result["sign"]["reason"], "the mesh is closed");
}

TEST_F(CommandOutput, AHoleIsClosedInThoughtAndSaid)
{
  TriangleMesh mesh = icosphere(0.5, 2);
  mesh.triangles.pop_back();
  mesh.triangleCells.pop_back();
  writeFile(input, objText(mesh));
  const Outcome outcome = run({ "-o", folder.file("axis.vtp"), "--report", folder.file("r.json") });
  EXPECT_TRUE(contains(outcome.err, "1 hole with 3 edges closed in thought")) << outcome.err;
  EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1);
  const Json result = Json::parse(readFile(folder.file("r.json")));
  EXPECT_EQ(result["sign_method"], "winding");
  EXPECT_EQ(result["sign"]["holes"], 1);
  EXPECT_EQ(result["sign"]["rim_edges"], 3);
}

TEST_F(CommandOutput, SignNoneOnAClosedMeshGivesBothSides)
{
  const Outcome outcome = run({ "--sign", "none", "-o", folder.file("axis.vtp") });
  EXPECT_TRUE(contains(outcome.err, "sign method none")) << outcome.err;
}

TEST_F(CommandOutput, ThreadsAndMemoryDoNotChangeTheResult)
{
  const auto expected = axis({});
  const auto limited = axis({ "--threads", "1", "--memory", "64" });
  ASSERT_EQ(limited->GetNumberOfPoints(), expected->GetNumberOfPoints());
  EXPECT_EQ(limited->GetPoint(5)[0], expected->GetPoint(5)[0]);
}

} // namespace
} // namespace medial::test
