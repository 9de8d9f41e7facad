// What the program does for --thickness-method, limits of thickness and --max-edge.
#include "command_run.h"

#include "support/shapes.h"
#include "support/thickness_shapes.h"
#include "support/transforms.h"
#include "support/tubes.h"

#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace medial::test
{
namespace
{

constexpr int kBeyondLimits = 1;

/// A rib 1 wide and 4 high on a base 3 high and 9 wide, 8 long, without points inside its faces.
TriangleMesh ribOnBase()
{
  const std::string rib = "....#....";
  const std::string base = "#########";
  return blocks({ rib, rib, rib, rib, base, base, base }, 4.0);
}

class CommandThicknessLimits : public CommandRun
{
protected:
  CommandThicknessLimits()
    : CommandRun(ribOnBase())
  {
  }

  Outcome check(std::vector<std::string> arguments) const
  {
    RunOptions options;
    options.folder = folder.path();
    arguments.insert(arguments.begin(), input);
    return runMedialAxis(arguments, options);
  }

  /// A run that must fail by one line and leave nothing.
  void expectRefused(const std::vector<std::string>& arguments, int code,
    const std::string& words) const
  {
    const Outcome outcome = check(arguments);
    EXPECT_EQ(outcome.exitCode, code) << outcome.err;
    EXPECT_TRUE(contains(outcome.err, words)) << outcome.err;
    EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
    EXPECT_EQ(folder.list(), std::vector<std::string>{ "box.obj" });
  }
};

TEST_F(CommandThicknessLimits, ThinRegionsAreATableAFileAReportAndAnExitCode)
{
  const Outcome outcome =
    check({ "--min-thickness", "2", "--thin-regions", "thin.vtp", "--report", "r.json" });
  EXPECT_EQ(outcome.exitCode, kBeyondLimits);
  EXPECT_TRUE(contains(outcome.err, "1 region is thinner than 2, the worst 1")) << outcome.err;
  EXPECT_TRUE(contains(outcome.out, "thickness interior (wall): min 1")) << outcome.out;
  EXPECT_TRUE(contains(outcome.out, "       1  thin           1")) << outcome.out;
  EXPECT_EQ(folder.list(), (std::vector<std::string>{ "box.obj", "r.json", "thin.vtp" }));

  const Json thickness = Json::parse(readFile(folder.file("r.json")))["thickness"];
  EXPECT_EQ(thickness["method"], "wall");
  EXPECT_EQ(thickness["angle"], 120.0); // not the default, 60
  EXPECT_EQ(thickness["min_limit"], 2.0);
  EXPECT_TRUE(thickness["max_limit"].is_null());
  ASSERT_EQ(thickness["regions"].size(), 1U);
  const Json region = thickness["regions"][0];
  EXPECT_EQ(keysOf(region), (std::set<std::string>{ "kind", "area", "value", "place", "cells" }));
  EXPECT_EQ(region["kind"], "thin");
  EXPECT_NEAR(region["value"].get<double>(), 1.0, 1e-6);
  EXPECT_NEAR(region["area"].get<double>(), 80.0, 4.0);
  EXPECT_EQ(region["place"].size(), 3U);
  EXPECT_GT(region["cells"].size(), 5U);

  const auto surface = readVtp(folder.file("thin.vtp"));
  ASSERT_GT(surface->GetNumberOfPolys(), 100);
  vtkDataArray* numbers = surface->GetCellData()->GetArray("Region");
  vtkDataArray* cells = surface->GetCellData()->GetArray("InputCell");
  ASSERT_NE(numbers, nullptr);
  ASSERT_NE(cells, nullptr);
  EXPECT_EQ(numbers->GetRange()[0], 1.0);
  EXPECT_EQ(numbers->GetRange()[1], 1.0);
  const auto ids = region["cells"].get<std::vector<double>>();
  for (vtkIdType i = 0; i < cells->GetNumberOfTuples(); ++i)
  {
    ASSERT_TRUE(std::binary_search(ids.begin(), ids.end(), cells->GetTuple1(i)));
  }
  EXPECT_NEAR(surface->GetCellData()->GetArray("Thickness")->GetRange()[0], 1.0, 1e-6);
}

// As files of CAD programs have them: divided, they were thin places.
TEST_F(CommandThicknessLimits, TrianglesWithoutAreaAreNoThinPlaces)
{
  const TriangleMesh plate = turned(turned(box({ 5.0, 3.0, 0.1 }), 0, 0.7), 2, 1.1);
  const std::string dirty = folder.file("dirty.obj");
  writeFile(dirty, objText(withFlatTriangles(plate, 40, 0.0, 5)));
  for (const std::string method : { "ball", "ray", "wall" })
  {
    RunOptions options;
    options.folder = folder.path();
    const Outcome outcome = runMedialAxis(
      { dirty, "--thickness-method", method, "--min-thickness", "0.3", "--report", "r.json" },
      options);
    EXPECT_EQ(outcome.exitCode, kBeyondLimits);
    EXPECT_TRUE(contains(outcome.out, "without area")) << outcome.out;
    const Json regions = Json::parse(readFile(folder.file("r.json")))["thickness"]["regions"];
    ASSERT_EQ(regions.size(), method == "wall" ? 1U : 2U) << outcome.out;
    double area = 0.0;
    for (const Json& region : regions)
    {
      EXPECT_NEAR(region["value"].get<double>(), 0.2, 1e-4);
      area += region["area"].get<double>();
    }
    EXPECT_NEAR(area, method == "wall" ? 126.4 : (method == "ball" ? 114.0 : 120.0),
      method == "ball" ? 2.0 : 1e-2);
  }
}

TEST_F(CommandThicknessLimits, ALimitBeyondTheDiagonalIsNoted)
{
  const Outcome outcome = check({ "--min-thickness", "200%" });
  EXPECT_EQ(outcome.exitCode, kBeyondLimits);
  EXPECT_TRUE(contains(outcome.err, "no place can be as thick as --min-thickness ")) << outcome.err;
  EXPECT_FALSE(contains(check({ "--min-thickness", "99%" }).err, "no place")) << outcome.err;
}

TEST_F(CommandThicknessLimits, RaysHaveNoAngle)
{
  check({ "--min-thickness", "0.5", "--thickness-method", "ray", "--report", "r.json" });
  EXPECT_TRUE(Json::parse(readFile(folder.file("r.json")))["thickness"]["angle"].is_null());
}

TEST_F(CommandThicknessLimits, LimitsThatAreKeptAreSuccess)
{
  const Outcome outcome = check({ "--min-thickness", "0.9", "--thin-regions", "thin.vtp" });
  EXPECT_EQ(outcome.exitCode, 0) << outcome.err;
  EXPECT_TRUE(contains(outcome.out, "limits    kept everywhere")) << outcome.out;
  EXPECT_EQ(readVtp(folder.file("thin.vtp"))->GetNumberOfPolys(), 0);
  EXPECT_EQ(check({ "--min-thickness", "0.9", "-q" }).out, "");
  // The checks alone compute no axis.
  EXPECT_EQ(folder.list(), (std::vector<std::string>{ "box.obj", "thin.vtp" }));
}

TEST_F(CommandThicknessLimits, ThickRegionsToo)
{
  const Outcome outcome = check({ "--max-thickness", "2", "-q" });
  EXPECT_EQ(outcome.exitCode, kBeyondLimits);
  EXPECT_TRUE(contains(outcome.err, "thicker than 2, the worst")) << outcome.err;
}

TEST_F(CommandThicknessLimits, LimitsMayBeShares)
{
  // The diagonal is sqrt(81 + 49 + 64): the rib has 7.2 % of it.
  EXPECT_EQ(check({ "--min-thickness", "7%" }).exitCode, 0);
  EXPECT_EQ(check({ "--min-thickness", "8%" }).exitCode, kBeyondLimits);
}

TEST_F(CommandThicknessLimits, MethodsDiffer)
{
  const auto values = [&](const std::string& method)
  {
    run({ "--thickness", folder.file("t.vtp"), "--thickness-method", method, "--max-edge", "0.4" });
    return readVtp(folder.file("t.vtp"));
  };
  const auto ball = values("ball");
  const auto ray = values("ray");
  const auto wall = values("wall");
  const auto least = [](vtkPolyData* surface)
  { return surface->GetPointData()->GetArray("Thickness")->GetRange()[0]; };
  EXPECT_EQ(least(ball), 0.0);
  EXPECT_NEAR(least(ray), 1.0, 1e-5);
  EXPECT_NEAR(least(wall), 1.0, 1e-5);
  EXPECT_GT(ball->GetNumberOfPolys(), 1000);
  EXPECT_EQ(ball->GetCellData()->GetArray("Thickness")->GetNumberOfTuples(),
    ball->GetNumberOfPolys());
}

// A mesh of eight points has values at the centres of its triangles.
TEST_F(CommandThicknessLimits, CellsHaveValues)
{
  writeFile(input, objText(box({ 2.0, 1.0, 0.5 })));
  run({ "--thickness", folder.file("t.vtp") });
  const auto surface = readVtp(folder.file("t.vtp"));
  EXPECT_EQ(surface->GetNumberOfPoints(), 8);
  EXPECT_EQ(surface->GetCellData()->GetArray("Thickness")->GetDataType(), VTK_FLOAT);
  EXPECT_NEAR(surface->GetCellData()->GetArray("Thickness")->GetRange()[1], 1.0, 1e-6);
}

TEST_F(CommandThicknessLimits, PicturesOfDividedMeshesAreDrawn)
{
  run({ "--thickness-image", folder.file("t.png"), "--max-edge", "5%", "--thickness-method",
    "wall" });
  EXPECT_EQ(readPng(folder.file("t.png"))->GetDimensions()[0], 1600);
}

TEST_F(CommandThicknessLimits, ContradictionsAreRefused)
{
  expectRefused({ "--min-thickness", "2", "--max-thickness", "1", "--thickness", "t.vtp" }, kUsage,
    "minimum thickness 2 is not below maximum thickness 1");
  expectRefused({ "--min-thickness", "50%", "--max-thickness", "1" }, kUsage, "is not below");
  expectRefused({ "--min-thickness", "0" }, kUsage, "0 is not a length > 0");
  expectRefused({ "--max-thickness", "-1" }, kUsage, "-1 is not a length > 0");
  expectRefused({ "--thin-regions", "t.vtp" }, kUsage, "--thin-regions t.vtp needs");
  expectRefused({ "--max-edge", "1" }, kUsage, "--max-edge 1 needs");
  expectRefused({ "--thickness-method", "ray" }, kUsage, "--thickness-method ray needs");
  expectRefused({ "--thickness", "t.vtp", "--thickness-method", "rod" }, kUsage, "rod");
  expectRefused({ "--thickness", "t.vtp", "--max-edge", "1e-9" }, kBadInput, "1e-09");
}

TEST_F(CommandThicknessLimits, OneSideOfAnOpenMeshHasNone)
{
  writeFile(input, objText(subdivided(plates(0.1, 1.0), 2)));
  expectRefused({ "--min-thickness", "1", "--thickness", "t.vtp" }, kBadInput,
    "need a mesh with an inside");
  expectRefused({ "--min-thickness", "1", "--side", "exterior" }, kBadInput, "inside");
  EXPECT_EQ(check({ "--min-thickness", "1", "--side", "both" }).exitCode, kBeyondLimits);
  // A vessel that is cut at its ends has one.
  writeFile(input, objText(openTube(0.2, 4.0, 32)));
  EXPECT_EQ(check({ "--min-thickness", "0.3" }).exitCode, 0);
}

} // namespace
} // namespace medial::test
