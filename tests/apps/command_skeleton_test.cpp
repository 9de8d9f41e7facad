// What medial-axis --skeleton and --skeleton-table write, and what they refuse.
#include "command_run.h"

#include "support/brute_force.h"
#include "support/models.h"
#include "support/shapes.h"
#include "support/transforms.h"
#include "support/tubes.h"

#include <vtkCell.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace medial::test
{
namespace
{

constexpr double kRadius = 0.25;

class CommandSkeleton : public CommandRun
{
protected:
  /// A T of tubes whose arms have the lengths 1.5, 1.2 and 1.
  CommandSkeleton()
    : CommandRun(unionOf({ { {}, { 1.5, 0.0, 0.0 }, kRadius }, { {}, { -1.2, 0.0, 0.0 }, kRadius },
                           { {}, { 0.0, 1.0, 0.0 }, kRadius } },
                   0.08),
        "tee.obj")
  {
  }

  std::string refusal(std::vector<std::string> arguments, int exitCode) const
  {
    arguments.insert(arguments.begin(), input);
    const Outcome outcome = runMedialAxis(arguments);
    EXPECT_EQ(outcome.exitCode, exitCode) << outcome.err;
    EXPECT_EQ(folder.list(), std::vector<std::string>{ "tee.obj" });
    return outcome.err;
  }
};

std::vector<std::vector<std::string>> readTable(const std::string& path)
{
  std::istringstream text(readFile(path));
  std::vector<std::vector<std::string>> rows;
  for (std::string line; std::getline(text, line);)
  {
    std::istringstream words(line);
    rows.emplace_back();
    for (std::string word; std::getline(words, word, ',');)
    {
      rows.back().push_back(word);
    }
  }
  return rows;
}

TEST_F(CommandSkeleton, WritesBranchesThatShareTheirJunction)
{
  const Outcome outcome = run({ "--resolution", "72", "--skeleton", folder.file("s.vtp") });
  EXPECT_EQ(folder.list(), (std::vector<std::string>{ "s.vtp", "tee.obj" }));
  EXPECT_TRUE(
    contains(outcome.out, "skeleton  3 branches, 1 junction, 0 loops, 1 component, length 3."))
    << outcome.out;
  EXPECT_TRUE(contains(outcome.out, "s.vtp: skeleton"));
  const auto skeleton = readVtp(folder.file("s.vtp"));
  ASSERT_EQ(skeleton->GetNumberOfLines(), 3);
  EXPECT_EQ(skeleton->GetNumberOfCells(), 3);
  vtkPointData* points = skeleton->GetPointData();
  vtkCellData* cells = skeleton->GetCellData();
  for (const char* name : { "Radius", "ArcLength", "Degree", "Tangent" })
  {
    ASSERT_NE(points->GetArray(name), nullptr) << name;
  }
  const std::vector<double> lengths{ 1.5, 1.2, 1.0 };
  const vtkIdType junction = skeleton->GetCell(0)->GetPointId(0);
  EXPECT_EQ(points->GetArray("Degree")->GetTuple1(junction), 3.0);
  for (vtkIdType branch = 0; branch < 3; ++branch)
  {
    EXPECT_EQ(skeleton->GetCell(branch)->GetPointId(0), junction);
    EXPECT_EQ(cells->GetArray("BranchId")->GetTuple1(branch), branch);
    EXPECT_EQ(cells->GetArray("Kind")->GetTuple1(branch), 0.0);
    EXPECT_NEAR(cells->GetArray("Length")->GetTuple1(branch), lengths[branch], 0.02);
    EXPECT_NEAR(cells->GetArray("MeanRadius")->GetTuple1(branch), kRadius, 0.02 * kRadius + 0.005);
    const vtkIdType end =
      skeleton->GetCell(branch)->GetPointId(skeleton->GetCell(branch)->GetNumberOfPoints() - 1);
    EXPECT_EQ(points->GetArray("Degree")->GetTuple1(end), 1.0);
    EXPECT_EQ(points->GetArray("ArcLength")->GetTuple1(end),
      cells->GetArray("Length")->GetTuple1(branch));
  }
}

TEST_F(CommandSkeleton, WritesATableWithTheSameFigures)
{
  run({ "--resolution", "72", "--skeleton", folder.file("s.vtp"), "--skeleton-table",
    folder.file("s.csv"), "--report", folder.file("r.json") });
  const auto skeleton = readVtp(folder.file("s.vtp"));
  const auto rows = readTable(folder.file("s.csv"));
  ASSERT_EQ(rows.size(), 4u);
  EXPECT_EQ(rows[0],
    (std::vector<std::string>{ "branch", "kind", "length", "mean_radius", "min_radius",
      "max_radius", "start_x", "start_y", "start_z", "end_x", "end_y", "end_z" }));
  const std::vector<const char*> arrays{ "Length", "MeanRadius", "MinRadius", "MaxRadius" };
  for (vtkIdType branch = 0; branch < 3; ++branch)
  {
    const auto& row = rows[branch + 1];
    EXPECT_EQ(row[0], std::to_string(branch));
    EXPECT_EQ(row[1], "end-junction");
    for (std::size_t i = 0; i < arrays.size(); ++i)
    {
      EXPECT_EQ(std::stod(row[2 + i]),
        skeleton->GetCellData()->GetArray(arrays[i])->GetTuple1(branch));
    }
    vtkCell* cell = skeleton->GetCell(branch);
    double end[3];
    skeleton->GetPoint(cell->GetPointId(cell->GetNumberOfPoints() - 1), end);
    EXPECT_EQ(std::stod(row[9]), end[0]);
    EXPECT_EQ(std::stod(row[10]), end[1]);
    EXPECT_EQ(std::stod(row[11]), end[2]);
  }
  const Json report = Json::parse(readFile(folder.file("r.json")));
  EXPECT_EQ(keysOf(report["skeleton"]),
    (std::set<std::string>{ "points", "branches", "end_junction", "junction_junction", "closed",
      "isolated", "junctions", "components", "loops", "length", "opened_cavities",
      "thinnest_radius", "seconds" }));
  EXPECT_EQ(report["skeleton"]["branches"], 3);
  EXPECT_EQ(report["skeleton"]["end_junction"], 3);
  EXPECT_EQ(report["skeleton"]["loops"], 0);
  EXPECT_EQ(report["parameters"]["topology"], "preserve");
  EXPECT_EQ(report["parameters"]["min_branch"], 1.0);
  EXPECT_EQ(report["parameters"]["smooth"], true);
}

TEST_F(CommandSkeleton, IsDrawnInPictures)
{
  const auto inks = [&](std::vector<std::string> arguments)
  {
    arguments.insert(arguments.end(),
      { "--resolution", "48", "--image", folder.file("p.png"), "--topology", "preserve" });
    const Outcome outcome = run(arguments);
    const auto picture = readPng(folder.file("p.png"));
    int dark = 0;
    for (int y = 0; y < picture->GetDimensions()[1]; ++y)
    {
      for (int x = 0; x < picture->GetDimensions()[0] * 3 / 4; ++x) // without the scalar bar
      {
        double brightest = 0.0;
        for (int c = 0; c < 3; ++c)
        {
          brightest = std::max(brightest, picture->GetScalarComponentAsDouble(x, y, 0, c));
        }
        dark += brightest < 60.0 ? 1 : 0;
      }
    }
    return std::make_pair(dark, outcome.out);
  };
  const auto [withoutDots, axis] = inks({ "-o", folder.file("a.vtp") });
  const auto [withDots, skeleton] = inks({ "--skeleton", folder.file("s.vtp") });
  EXPECT_TRUE(contains(axis, "p.png: picture of axis and surface"));
  EXPECT_TRUE(contains(skeleton, "p.png: picture of skeleton and surface"));
  EXPECT_GT(withDots, withoutDots + 4 * 50); // three ends and a junction
}

/// A solid of revolution about z, 6 long: thicker at its ends, with a neck in the middle.
TriangleMesh withNeck(double radius)
{
  constexpr int kRings = 40;
  constexpr int kSides = 16;
  const double turn = 2.0 * std::acos(-1.0);
  std::vector<Point3> points{ { 0.0, 0.0, -3.0 }, { 0.0, 0.0, 3.0 } };
  std::vector<std::array<int, 3>> triangles;
  for (int ring = 0; ring < kRings; ++ring)
  {
    const double z = 6.0 * ring / (kRings - 1) - 3.0;
    const double r = 1.0 - (1.0 - radius) * std::exp(-4.0 * z * z);
    for (int side = 0; side < kSides; ++side)
    {
      points.push_back(
        { r * std::cos(turn * side / kSides), r * std::sin(turn * side / kSides), z });
      const int a = 2 + ring * kSides + side;
      const int b = 2 + ring * kSides + (side + 1) % kSides;
      if (ring > 0)
      {
        triangles.push_back({ a - kSides, b - kSides, b });
        triangles.push_back({ a - kSides, b, a });
      }
      if (ring == 0 || ring == kRings - 1)
      {
        triangles.push_back({ ring == 0 ? 0 : 1, ring == 0 ? b : a, ring == 0 ? a : b });
      }
    }
  }
  return makeMesh(points, triangles);
}

TEST_F(CommandSkeleton, ANoteTellsThatTheGridCutsIt)
{
  const std::string necked = folder.file("necked.obj");
  writeFile(necked, objText(withNeck(0.1)));
  const std::string skeleton = folder.file("s.vtp");
  const Outcome coarse = runMedialAxis({ necked, "--resolution", "22", "--skeleton", skeleton });
  ASSERT_EQ(coarse.exitCode, 0) << coarse.err;
  EXPECT_TRUE(contains(coarse.out, "2 components")) << coarse.out;
  EXPECT_TRUE(contains(coarse.err,
    "the skeleton falls into 2 components, while the mesh has 1: the grid may miss what is "
    "narrower "
    "than a voxel"))
    << coarse.err;
  const Outcome fine = runMedialAxis({ necked, "--resolution", "120", "--skeleton", skeleton });
  EXPECT_EQ(fine.err, "");
  const std::string ring = folder.file("ring.obj");
  writeFile(ring, objText(torus(1.0, 0.05, 60, 12)));
  const Outcome opened = runMedialAxis({ ring, "--resolution", "20", "--skeleton", skeleton });
  EXPECT_EQ(contains(opened.err, "loops, while the solid has 1") ||
      contains(opened.err, "components, while the mesh has 1"),
    !contains(opened.out, "1 loop, 1 component"))
    << opened.out << opened.err;
}

TEST_F(CommandSkeleton, OptionsChangeIt)
{
  const auto branches = [&](std::vector<std::string> arguments)
  {
    arguments.insert(arguments.end(),
      { "--resolution", "72", "--skeleton-table", folder.file("s.csv"), "-q" });
    run(arguments);
    return readTable(folder.file("s.csv"));
  };
  EXPECT_EQ(branches({ "--min-branch", "4.5" }).size(), 2u); // 1 / 0.25 is less
  const auto smooth = branches({});
  const auto rough = branches({ "--no-smooth" });
  ASSERT_EQ(rough.size(), 4u);
  EXPECT_GT(std::stod(rough[1][2]), std::stod(smooth[1][2]));
}

TEST_F(CommandSkeleton, FindsTheResolutionThatThinBranchesNeed)
{
  const auto chosen = [&](double radius)
  {
    writeFile(input,
      objText(unionOf({ { { -1.5, 0.0, 0.0 }, { 1.5, 0.0, 0.0 }, 0.3 },
                        { { 0.2, 0.0, 0.0 }, { 0.2, 0.9, 0.0 }, radius } },
        0.03)));
    const Outcome outcome = run({ "--resolution", "auto", "--skeleton-table", folder.file("s.csv"),
      "--report", folder.file("r.json") });
    EXPECT_TRUE(contains(outcome.out, ", thinnest branch: radius 0.")) << outcome.out;
    const auto rows = readTable(folder.file("s.csv"));
    EXPECT_EQ(rows.size(), 4u);
    // Of the stub, the shortest; the edges of its mesh make it thinner.
    EXPECT_NEAR(std::stod(rows.back()[4]), radius, 0.1 * radius);
    const Json report = Json::parse(readFile(folder.file("r.json")));
    EXPECT_NEAR(report["skeleton"]["thinnest_radius"].get<double>(), radius, 0.1 * radius);
    // An axis that is taken as it is does not count twice.
    const auto seconds = [&](const char* phase) { return report["seconds"][phase].get<double>(); };
    EXPECT_LT(seconds("prepare") + seconds("medial") + seconds("skeleton"), seconds("total"));
    return report["grid"]["dimensions"][0].get<int>();
  };
  EXPECT_NEAR(chosen(0.06), 4.0 * 4.0 / 0.06, 25.0);
  EXPECT_EQ(chosen(0.2), 128);
}

// Of a skeleton alone, too.
TEST_F(CommandSkeleton, TellsWhereTheGridIsTooCoarseForIt)
{
  const auto notes = [&](std::vector<std::string> arguments)
  {
    arguments.insert(arguments.end(), { "--skeleton-table", folder.file("s.csv") });
    return run(arguments).err;
  };
  EXPECT_EQ(notes({ "--resolution", "72" }), "");
  const std::string coarse = notes({ "--resolution", "8" });
  EXPECT_TRUE(contains(coarse, input + ": the thinnest branch has a radius of 0.2")) << coarse;
  const std::string needs = ": branches may be missing or stray; it needs --resolution ";
  const std::size_t needed = coarse.find(needs);
  ASSERT_NE(needed, std::string::npos) << coarse;
  EXPECT_EQ(notes({ "--resolution", coarse.substr(needed + needs.size(), 2) }), "");
  const std::string far = notes({ "--spacing", "0.3" });
  EXPECT_TRUE(contains(far, "; it needs --spacing 0.06")) << far;
  EXPECT_EQ(notes({ "--spacing", "0.06" }), "");
  EXPECT_EQ(notes({ "--resolution", "8", "-q" }), "");
}

TEST_F(CommandSkeleton, TellsOfPartsThatItLeavesOut)
{
  // A rod that no grid point is in.
  writeFile(input,
    objText(
      appended(box({ 1.0, 1.0, 0.6 }), translated(cylinder(0.04, 6.0, 24), { 0.03, 0.03, 5.0 }))));
  const Outcome outcome = run({ "--spacing", "0.25", "--skeleton", folder.file("s.vtp") });
  EXPECT_TRUE(contains(outcome.err, " % of the surface is farther than a voxel's diagonal, 0.433"))
    << outcome.err;
}

TEST_F(CommandSkeleton, EndsStayOnTheirSideOfAGap)
{
  const TriangleMesh rod = cylinder(0.5, 5.0, 24);
  writeFile(input, objText(appended(rod, translated(rod, { 0.0, 0.0, 5.15 }))));
  run({ "--resolution", "auto", "--skeleton-table", folder.file("s.csv") });
  const auto rows = readTable(folder.file("s.csv"));
  ASSERT_EQ(rows.size(), 3u);
  for (const std::size_t row : { 1, 2 })
  {
    EXPECT_EQ(rows[row][1], "isolated");
    EXPECT_NEAR(std::stod(rows[row][2]), 4.0, 0.05);
    EXPECT_NEAR(std::stod(rows[row][4]), 0.5, 0.01); // outside of the rods it would be less
  }
}

TEST_F(CommandSkeleton, ThePlatesLineHasBothEnds)
{
  const TriangleMesh plate = box({ 4.0, 2.0, 0.25 });
  for (const double turn : { 0.0, 0.5, 1.0 })
  {
    SCOPED_TRACE(turn);
    writeFile(input,
      objText(turned(turned(turned(plate, 0, 0.4 + turn), 1, 0.7 + turn), 2, 0.3 + turn)));
    for (const char* smooth : { "-q", "--no-smooth" })
    {
      run({ "--resolution", "200", "--skeleton-table", folder.file("s.csv"), smooth });
      const auto rows = readTable(folder.file("s.csv"));
      ASSERT_EQ(rows.size(), 2u);
      double square = 0.0;
      for (int i = 0; i < 3; ++i)
      {
        square += std::pow(std::stod(rows[1][6 + i]) - std::stod(rows[1][9 + i]), 2.0);
      }
      EXPECT_NEAR(std::sqrt(square), 4.0, 0.3);
    }
  }
}

TEST_F(CommandSkeleton, RefusesWhatDoesNotGoWithIt)
{
  const std::string file = folder.file("s.vtp");
  EXPECT_TRUE(contains(refusal({ "--skeleton", folder.file("s.ply") }, kUsage),
    "s.ply: unknown extension '.ply', allowed: .vtp"));
  EXPECT_TRUE(contains(refusal({ "--skeleton-table", folder.file("s.txt") }, kUsage),
    "s.txt: unknown extension '.txt', allowed: .csv"));
  const std::vector<std::vector<std::string>> wrong{ { "--topology", "selected" },
    { "--side", "exterior" }, { "--side", "both" }, { "--representation", "faces" },
    { "--max-spheres", "20" }, { "--sign", "none" } };
  for (std::vector<std::string> arguments : wrong)
  {
    SCOPED_TRACE(arguments[0]);
    arguments.insert(arguments.end(), { "--skeleton", file });
    const std::string message = refusal(arguments, kUsage);
    EXPECT_TRUE(contains(message, "--skeleton needs ")) << message;
    EXPECT_TRUE(contains(message, arguments[1])) << message;
  }
  EXPECT_TRUE(contains(refusal({ "--skeleton", file, "--min-branch", "-1" }, kUsage),
    "--min-branch: -1 is outside [0, infinity)"));
  EXPECT_TRUE(contains(refusal({ "--min-branch", "1" }, kUsage),
    "--min-branch needs --skeleton or --skeleton-table"));
  EXPECT_TRUE(contains(refusal({ "--no-smooth" }, kUsage),
    "--no-smooth needs --skeleton or --skeleton-table"));
  EXPECT_TRUE(contains(refusal({ "--resolution", "auto" }, kUsage),
    "--resolution auto is what a skeleton needs: it needs --skeleton or --skeleton-table"));
  EXPECT_TRUE(contains(refusal({ "--skeleton", file, "--resolution", "car" }, kUsage),
    "--resolution: car is not a whole number; allowed: [2, 8192] or auto"));
  EXPECT_TRUE(
    contains(refusal({ "--skeleton", file, "--resolution", "auto", "--spacing", "1" }, kUsage),
      "--resolution auto cannot be given together with --spacing 1"));
  EXPECT_TRUE(contains(refusal({ "--skeleton", file, "-o", file }, kUsage),
    "--output and --skeleton name the same"));
}

TEST_F(CommandSkeleton, RefusesMeshesWithoutAnInside)
{
  writeFile(input, objText(plates(0.5, 1.0)));
  const std::string message =
    refusal({ "--resolution", "24", "--skeleton", folder.file("s.vtp") }, kBadInput);
  EXPECT_TRUE(contains(message, "tee.obj: a skeleton needs to know inside from outside"))
    << message;
  EXPECT_TRUE(contains(message, "the mesh does not define an inside")) << message;
  EXPECT_TRUE(contains(message, "the sign method winding closes holes")) << message;
}

TEST_F(CommandSkeleton, TellsOfCavitiesThatItOpens)
{
  writeFile(input, objText(shell(0.6, 1.0, 2)));
  const Outcome outcome = run({ "--resolution", "32", "--skeleton", folder.file("s.vtp") });
  EXPECT_TRUE(contains(outcome.err, "curves cannot enclose cavities: 1 sheet around one has"))
    << outcome.err;
  EXPECT_EQ(readVtp(folder.file("s.vtp"))->GetNumberOfCells(), 1);
}

std::vector<std::vector<Point3>> linesOf(vtkPolyData* network)
{
  std::vector<std::vector<Point3>> lines;
  for (vtkIdType c = 0; c < network->GetNumberOfCells(); ++c)
  {
    lines.emplace_back();
    vtkCell* line = network->GetCell(c);
    for (vtkIdType i = 0; i < line->GetNumberOfPoints(); ++i)
    {
      network->GetPoint(line->GetPointId(i), lines.back().emplace_back().data());
    }
  }
  return lines;
}

/// The lines as triangles without area.
TriangleMesh meshOf(const std::vector<std::vector<Point3>>& lines)
{
  TriangleMesh mesh;
  for (const std::vector<Point3>& line : lines)
  {
    for (const Point3& point : line)
    {
      const auto id = static_cast<int>(mesh.points.size());
      mesh.points.push_back(point);
      if (&point != &line.front())
      {
        mesh.triangles.push_back({ id - 1, id, id });
      }
    }
  }
  return mesh;
}

class CommandAorta : public testing::TestWithParam<std::string>
{
};

TEST_P(CommandAorta, HasThePublishedCentreline)
{
  const TemporaryFolder folder;
  const std::string file = folder.file("s.vtp");
  ASSERT_EQ(runMedialAxis({ GetParam(), "-q", "--skeleton", file }).exitCode, 0);
  const auto skeleton = readVtp(file);
  EXPECT_EQ(skeleton->GetNumberOfCells(), 3);
  const auto published = readVtp(*modelPath("vessel/aorta_published_centreline.vtp"));
  const TriangleMesh lines = meshOf(linesOf(published));
  double sum = 0.0;
  for (vtkIdType p = 0; p < skeleton->GetNumberOfPoints(); ++p)
  {
    Point3 point;
    skeleton->GetPoint(p, point.data());
    sum += closestOnMesh(lines, point).distance /
      skeleton->GetPointData()->GetArray("Radius")->GetTuple1(p);
  }
  EXPECT_LT(sum / static_cast<double>(skeleton->GetNumberOfPoints()), 0.02);
}

/// If it is there, and with it the centreline. The published ends of the open one are off centre.
std::vector<std::string> aorta()
{
  const auto path = modelPath("vessel/aorta_closed_12.9k.stl");
  return path && modelPath("vessel/aorta_published_centreline.vtp")
    ? std::vector<std::string>{ *path }
    : std::vector<std::string>();
}

GTEST_ALLOW_UNINSTANTIATED_PARAMETERIZED_TEST(CommandAorta);
INSTANTIATE_TEST_SUITE_P(Closed, CommandAorta, testing::ValuesIn(aorta()));

} // namespace
} // namespace medial::test
