// What the program tells about the parts that its axis leaves out, and the curves of the axis.
#include "command_run.h"

#include "support/shapes.h"

#include <vtkCell.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkMath.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <cmath>
#include <map>

namespace medial::test
{
namespace
{

const double kPi = std::acos(-1.0);
constexpr Point3 kHalfSides{ 1.0, 0.7, 0.4 };

class CommandSelection : public CommandRun
{
protected:
  CommandSelection()
    : CommandRun(box(kHalfSides))
  {
  }

  // The report's coverage; the notes of the run go to `notes`.
  Json coverage(std::vector<std::string> arguments)
  {
    arguments.insert(arguments.end(),
      { "-o", folder.file("axis.vtp"), "--report", folder.file("report.json") });
    notes = run(arguments).err;
    return Json::parse(readFile(folder.file("report.json")))["coverage"];
  }

  std::string notes;
};

/// A plate of 2 x 2 x 0.4 with nine round pins above it, 0.08 wide and 1.2 long.
struct PlateWithPins
{
  static constexpr double kPlateTop = 0.2;
  TriangleMesh mesh = box({ 1.0, 1.0, kPlateTop });
  double pinShare = 0.0; ///< of the area

  PlateWithPins()
  {
    constexpr int kSides = 24;
    constexpr double kRadius = 0.04;
    constexpr double kHeight = 1.2;
    const TriangleMesh pin = cylinder(kRadius, kHeight, kSides);
    for (const double x : { -0.587, 0.013, 0.613 })
    {
      for (const double y : { -0.593, 0.007, 0.607 })
      {
        mesh = appended(mesh, translated(pin, { x, y, kPlateTop + 0.5 + 0.5 * kHeight }));
      }
    }
    const double angle = kPi / kSides;
    const double pinArea = 2.0 * kSides * kRadius * std::sin(angle) * kHeight +
      kSides * kRadius * kRadius * std::sin(2.0 * angle);
    const double plateArea = 8.0 * (1.0 + 2.0 * kPlateTop);
    pinShare = 9.0 * pinArea / (9.0 * pinArea + plateArea);
  }
};

TEST_F(CommandSelection, NothingOfABoxIsUncovered)
{
  for (const char* kind : { "surface", "faces", "points" })
  {
    const Json result = coverage({ "--spacing", "0.05", "--representation", kind });
    EXPECT_EQ(result["uncovered_share"], 0.0) << kind;
    EXPECT_NEAR(result["reach"].get<double>(), 0.05 * std::sqrt(3.0), 1e-12);
    EXPECT_EQ(result["samples"], 20000);
    EXPECT_EQ(notes, "");
  }
}

TEST_F(CommandSelection, PinsThatAreLostAreReported)
{
  const PlateWithPins shape;
  writeFile(input, objText(shape.mesh));
  // With this spacing no pin's axis lies between two neighbouring grid points.
  const double share = coverage({ "--spacing", "0.2" })["uncovered_share"];
  double bounds[6];
  readVtp(folder.file("axis.vtp"))->GetBounds(bounds);
  ASSERT_LT(bounds[5], shape.kPlateTop);
  EXPECT_NEAR(share, shape.pinShare, 0.001);
  EXPECT_TRUE(contains(notes, input + ": 20 % of the surface is farther than a voxel's diagonal"))
    << notes;
  EXPECT_TRUE(contains(notes, ", near (")) << notes;
  const std::size_t hint = notes.find("; --spacing ");
  ASSERT_NE(hint, std::string::npos) << notes;
  const std::string spacing = notes.substr(hint + 12, notes.find(' ', hint + 12) - hint - 12);
  // No pin is lost, though the grid may still miss the ends of some.
  EXPECT_LT(coverage({ "--spacing", spacing })["uncovered_share"].get<double>(), 0.01) << spacing;
  // Thinner than lambda at any spacing.
  EXPECT_NEAR(
    coverage({ "--spacing", "0.03", "--lambda", "0.05" })["uncovered_share"].get<double>(),
    shape.pinShare, 0.001);
  EXPECT_FALSE(contains(notes, "; --spacing")) << notes;
  EXPECT_EQ(coverage({ "--spacing", "0.025" })["uncovered_share"], 0.0);
  EXPECT_EQ(notes, "");
}

/// What the middle sheet of the box leaves uncovered, where it ends `early` all around.
double uncoveredByMiddleSheet(double reach, double early)
{
  const auto [a, b, c] = kHalfSides;
  const double u = a - c - early;
  const double v = b - c - early;
  // Around the places beside the sheet, and around its border on the other sides of the box.
  const double beside = std::sqrt((c + reach) * (c + reach) - c * c);
  const double border = std::sqrt((c + reach) * (c + reach) - (c + early) * (c + early));
  const double covered = 8.0 * u * v + 8.0 * (u + v) * beside + 2.0 * kPi * beside * beside +
    8.0 * (u + v) * border + 4.0 * kPi * border * border;
  return 1.0 - covered / (8.0 * (a * b + b * c + c * a));
}

/// The edges bend by 90 degrees, so a theta of 120 leaves the middle sheet alone.
TEST_F(CommandSelection, AngleLeavesTheEdgesOfABoxUncovered)
{
  const Json result = coverage({ "--spacing", "0.01", "--angle", "120" });
  const double share = result["uncovered_share"];
  // A sheet ends less than a spacing before its border.
  EXPECT_GT(share, uncoveredByMiddleSheet(result["reach"], 0.0));
  EXPECT_LT(share, uncoveredByMiddleSheet(result["reach"], 0.01));
  EXPECT_TRUE(contains(notes, " % of the surface is farther than a voxel's diagonal")) << notes;
}

TEST_F(CommandSelection, CoverageIsInTheSummaryWhereItIsAskedFor)
{
  const Outcome plain = run({ "--resolution", "24" });
  EXPECT_FALSE(contains(plain.out, "coverage")) << plain.out;
  const Outcome asked = run({ "--resolution", "24", "--coverage" });
  EXPECT_TRUE(
    contains(asked.out, "coverage  0 % of the surface is farther than a voxel's diagonal"))
    << asked.out;
  const Outcome outside = run({ "--resolution", "24", "--coverage", "--side", "exterior" });
  EXPECT_TRUE(contains(outside.out, "coverage  is that of an interior axis alone")) << outside.out;
}

TEST_F(CommandSelection, AnAxisOfAnotherSideHasNoCoverage)
{
  EXPECT_TRUE(coverage({ "--resolution", "24", "--side", "both" }).is_null());
  EXPECT_EQ(notes, "");
  EXPECT_TRUE(coverage({ "--resolution", "24", "--sign", "none" }).is_null());
  EXPECT_TRUE(coverage({ "--resolution", "24", "--side", "exterior" }).is_null());
  EXPECT_FALSE(contains(notes, "farther")) << notes;
}

TEST_F(CommandSelection, AnEmptyAxisCoversNothing)
{
  EXPECT_EQ(coverage({ "--resolution", "24", "--min-radius", "1" })["uncovered_share"], 1.0);
}

std::map<int, double> lengthsByFeature(vtkPolyData* curves)
{
  std::map<int, double> lengths;
  for (vtkIdType cell = 0; cell < curves->GetNumberOfCells(); ++cell)
  {
    const double feature = curves->GetCellData()->GetArray("AxisFeature")->GetTuple1(cell);
    vtkPoints* points = curves->GetCell(cell)->GetPoints();
    for (vtkIdType i = 0; i + 1 < points->GetNumberOfPoints(); ++i)
    {
      double a[3];
      double b[3];
      points->GetPoint(i, a);
      points->GetPoint(i + 1, b);
      lengths[static_cast<int>(feature)] += std::sqrt(vtkMath::Distance2BetweenPoints(a, b));
    }
  }
  return lengths;
}

TEST_F(CommandSelection, TheCurvesOfABoxHaveTheirLengths)
{
  // With the second the seams run through grid points, where three sites are equally close.
  for (const std::string spacing : { "0.0253", "0.025" })
  {
    SCOPED_TRACE(spacing);
    const Outcome outcome = run({ "--spacing", spacing, "--curves", folder.file("curves.vtp") });
    EXPECT_EQ(folder.list(), (std::vector<std::string>{ "box.obj", "curves.vtp" }));
    const auto curves = readVtp(folder.file("curves.vtp"));
    EXPECT_TRUE(contains(outcome.out,
      "curves.vtp: curves of the axis, " + std::to_string(curves->GetNumberOfCells()) +
        " polylines"))
      << outcome.out;
    EXPECT_EQ(curves->GetNumberOfCells(), 4 + 8 + 12);
    ASSERT_NE(curves->GetPointData()->GetArray("Radius"), nullptr);
    std::map<int, double> lengths = lengthsByFeature(curves);
    // Seams: around the middle sheet, and from its corners to those of the box; rims: the edges.
    // Each of the eight ends stops short of its corner.
    const auto [a, b, c] = kHalfSides;
    const double h = std::stod(spacing);
    const double seams = 4.0 * (a - c) + 4.0 * (b - c) + 8.0 * std::sqrt(3.0) * c;
    EXPECT_LE(lengths[2], 1.02 * seams);
    EXPECT_GE(lengths[2], seams - 8 * 2.5 * h);
    EXPECT_LE(lengths[1], 8.0 * (a + b + c));
    EXPECT_GE(lengths[1], 8.0 * (a + b + c) - 24 * 1.5 * h);
  }
}

TEST_F(CommandSelection, CurvesGoWithAxisAndReport)
{
  run({ "--resolution", "24", "-o", folder.file("axis.ma"), "--curves", folder.file("c.vtp"),
    "--report", folder.file("r.json") });
  EXPECT_EQ(folder.list(), (std::vector<std::string>{ "axis.ma", "box.obj", "c.vtp", "r.json" }));
  EXPECT_GT(readVtp(folder.file("c.vtp"))->GetNumberOfLines(), 10);
}

TEST_F(CommandSelection, RefusesCurvesThatCannotBe)
{
  const auto error = [&](std::vector<std::string> arguments)
  {
    arguments.insert(arguments.begin(), input);
    const Outcome outcome = runMedialAxis(arguments);
    EXPECT_EQ(outcome.exitCode, kUsage);
    EXPECT_EQ(folder.list(), std::vector<std::string>{ "box.obj" });
    return outcome.err;
  };
  const std::string curves = folder.file("curves.vtp");
  EXPECT_TRUE(contains(error({ "--curves", folder.file("curves.obj") }),
    "curves.obj: unknown extension '.obj', allowed: .vtp"));
  EXPECT_TRUE(contains(error({ "--curves", curves, "--representation", "points" }),
    "--curves needs --representation surface or faces"));
  EXPECT_TRUE(contains(error({ "-o", curves, "--curves", curves }),
    "--output and --curves name the same file"));
  EXPECT_TRUE(contains(error({ "--curves", curves, "--thickness", curves }),
    "--curves and --thickness name the same file"));
}

TEST_F(CommandSelection, ARunThatFailsLeavesOldCurves)
{
  writeFile(folder.file("c.vtp"), "old");
  const Outcome outcome = runMedialAxis({ input, "--resolution", "24", "--curves",
    folder.file("c.vtp"), "-o", folder.file("no/such/axis.vtp") });
  EXPECT_EQ(outcome.exitCode, 5) << outcome.err;
  EXPECT_EQ(readFile(folder.file("c.vtp")), "old");
  EXPECT_EQ(folder.list(), (std::vector<std::string>{ "box.obj", "c.vtp" }));
}

} // namespace
} // namespace medial::test
