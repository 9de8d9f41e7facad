// What the program does for --thickness and --thickness-image.
#include "command_run.h"
#include "scalar_bar.h"

#include "support/models.h"
#include "support/shapes.h"
#include "support/transforms.h"

#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

namespace medial::test
{
namespace
{

class CommandThickness : public CommandRun
{
protected:
  CommandThickness()
    : CommandRun(subdivided(box({ 1.0, 0.7, 0.4 }), 3))
  {
  }

  vtkSmartPointer<vtkPolyData> thickness(std::vector<std::string> arguments = {}) const
  {
    arguments.insert(arguments.end(), { "--thickness", folder.file("t.vtp") });
    run(arguments);
    return readVtp(folder.file("t.vtp"));
  }
};

double valueAt(vtkPolyData* surface, vtkIdType point)
{
  return surface->GetPointData()->GetArray("Thickness")->GetTuple1(point);
}

// Share of the picture's points that `test` is true for, left of the scalar bar.
template <typename Test>
double shareOf(const std::string& path, const Test& test)
{
  const auto picture = readPng(path);
  EXPECT_EQ(picture->GetDimensions()[0], 1600);
  EXPECT_EQ(picture->GetDimensions()[1], 1200);
  int found = 0;
  int all = 0;
  for (int y = 0; y < 1200; y += 4)
  {
    for (int x = 0; x < 1200; x += 4)
    {
      std::array<double, 3> rgb{};
      for (int channel = 0; channel < 3; ++channel)
      {
        rgb[channel] = picture->GetScalarComponentAsDouble(x, y, 0, channel);
      }
      found += test(rgb) ? 1 : 0;
      ++all;
    }
  }
  return static_cast<double>(found) / all;
}

double spread(const std::array<double, 3>& rgb)
{
  return *std::max_element(rgb.begin(), rgb.end()) - *std::min_element(rgb.begin(), rgb.end());
}

TEST_F(CommandThickness, IsThatOfTheInputSurface)
{
  const auto surface = thickness();
  EXPECT_EQ(surface->GetNumberOfPolys(), 12 * 64);
  EXPECT_EQ(surface->GetPointData()->GetArray("Thickness")->GetDataType(), VTK_FLOAT);
  int inside = 0;
  for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
  {
    double x[3];
    surface->GetPoint(i, x);
    if (std::abs(x[2]) > 0.39 && std::abs(x[0]) < 0.55 && std::abs(x[1]) < 0.25)
    {
      ++inside;
      ASSERT_NEAR(valueAt(surface, i), 0.8, 1e-6);
    }
  }
  EXPECT_GE(inside, 10);
}

TEST_F(CommandThickness, SaysWhichOptionsHaveNoEffect)
{
  const std::vector<std::string> wanted{ input, "--thickness", folder.file("t.vtp"), "--spacing",
    "0.1", "--lambda", "1%", "--angle", "70" };
  EXPECT_EQ(runMedialAxis(wanted).err,
    "medial-axis: note: --spacing has no effect, since no output needs a grid\n"
    "medial-axis: note: --lambda has no effect, since no output needs the axis\n");
  std::vector<std::string> withField = wanted;
  withField.insert(withField.end(), { "--field", folder.file("f.vti") });
  EXPECT_EQ(runMedialAxis(withField).err,
    "medial-axis: note: --lambda has no effect, since no output needs the axis\n");
  std::vector<std::string> withAxis = wanted;
  withAxis.insert(withAxis.end(), { "-o", folder.file("a.vtp") });
  EXPECT_FALSE(contains(runMedialAxis(withAxis).err, "no effect"));
}

// No axis, no grid, no OpenGL: it works where there is none.
TEST_F(CommandThickness, AloneComputesNothingElse)
{
  RunOptions options;
  options.environment = { { "__EGL_VENDOR_LIBRARY_FILENAMES", "/nonexistent" } };
  options.folder = folder.path();
  const Outcome outcome =
    runMedialAxis({ input, "--thickness", "t.vtp", "--require-gpu" }, options);
  EXPECT_EQ(outcome.exitCode, 0) << outcome.err;
  EXPECT_EQ(outcome.err, "");
  EXPECT_EQ(folder.list(), (std::vector<std::string>{ "box.obj", "t.vtp" }));
  EXPECT_TRUE(contains(outcome.out, "thickness interior: min 0, median")) << outcome.out;
  EXPECT_FALSE(contains(outcome.out, "engine")) << outcome.out;
  EXPECT_EQ(runMedialAxis({ input, "-o", "a.vtp", "--require-gpu" }, options).exitCode, kNoGpu);
}

TEST_F(CommandThickness, GoesWithTheOtherOutputs)
{
  run({ "--thickness", folder.file("t.vtp"), "--thickness-image", folder.file("t.png"), "-o",
    folder.file("a.ply"), "--field", folder.file("f.vti"), "--resolution", "16" });
  EXPECT_EQ(folder.list(),
    (std::vector<std::string>{ "a.ply", "box.obj", "f.vti", "t.png", "t.vtp" }));
}

TEST_F(CommandThickness, SideAndAngleApply)
{
  const auto outside = thickness({ "--side", "exterior" });
  for (vtkIdType i = 0; i < outside->GetNumberOfPoints(); ++i)
  {
    ASSERT_TRUE(std::isnan(valueAt(outside, i)));
  }
  const auto wide = thickness({ "--angle", "120" });
  for (vtkIdType i = 0; i < wide->GetNumberOfPoints(); ++i)
  {
    ASSERT_FALSE(valueAt(wide, i) < 0.76)
      << "no ball of this size touches two sides at 120 degrees";
  }
}

TEST_F(CommandThickness, ReportHasItsFigures)
{
  thickness({ "--report", folder.file("r.json") });
  const Json result = Json::parse(readFile(folder.file("r.json")))["thickness"];
  std::set<std::string> keys;
  for (const auto& item : result.items())
  {
    keys.insert(item.key());
  }
  EXPECT_EQ(keys,
    (std::set<std::string>{ "method", "side", "angle", "min", "percentile_5", "median",
      "percentile_95", "max", "share_without", "triangles", "min_limit", "max_limit", "regions",
      "seconds" }));
  EXPECT_EQ(result["method"], "ball");
  EXPECT_TRUE(result["regions"].is_null());
  EXPECT_EQ(result["side"], "interior");
  EXPECT_EQ(result["angle"], 60.0);
  EXPECT_EQ(result["min"], 0.0);
  EXPECT_NEAR(result["max"].get<double>(), 0.8, 1e-6);
  EXPECT_GT(result["median"].get<double>(), 0.0);
  EXPECT_EQ(result["share_without"], 0.0);
  EXPECT_GT(result["seconds"].get<double>(), 0.0);

  thickness({ "--side", "exterior", "--report", folder.file("r.json") });
  const Json none = Json::parse(readFile(folder.file("r.json")))["thickness"];
  EXPECT_EQ(none["share_without"], 1.0);
  EXPECT_TRUE(none["median"].is_null());
}

TEST_F(CommandThickness, PictureIsColouredByIt)
{
  run({ "--thickness-image", folder.file("t.png") });
  EXPECT_GT(shareOf(folder.file("t.png"), [](const auto& rgb) { return spread(rgb) > 40.0; }), 0.2);
}

// The corners of a box are its only points, but its faces show what is between.
TEST_F(CommandThickness, PictureOfACoarseMeshShowsWhatIsInsideItsTriangles)
{
  writeFile(input, objText(box({ 1.0, 0.7, 0.4 })));
  run({ "--thickness-image", folder.file("t.png") });
  const auto yellow = [](const auto& rgb) { return rgb[1] - rgb[2] > 60.0; };
  EXPECT_GT(shareOf(folder.file("t.png"), yellow), 0.05);
}

TEST_F(CommandThickness, PictureIsGreyWhereThereIsNone)
{
  run({ "--side", "exterior", "--thickness-image", folder.file("t.png") });
  const auto grey = [](const auto& rgb) { return spread(rgb) < 3.0 && rgb[0] < 250.0; };
  EXPECT_GT(shareOf(folder.file("t.png"), grey), 0.2);
}

TEST(ScaleTicks, AreRoundBetweenTheEnds)
{
  EXPECT_EQ(app::scaleTicks(21.05), (std::vector<double>{ 0.0, 5.0, 10.0, 15.0, 21.05 }));
  EXPECT_EQ(app::scaleTicks(0.25), (std::vector<double>{ 0.0, 0.05, 0.1, 0.05 * 3, 0.2, 0.25 }));
  EXPECT_EQ(app::scaleTicks(0.0), std::vector<double>{ 0.0 });
  for (const double max : { 1e-7, 0.31, 1.0, 1.99, 9.999, 12.4, 12345.0, 3e9 })
  {
    const std::vector<double> ticks = app::scaleTicks(max);
    EXPECT_GE(ticks.size(), 4U) << max;
    EXPECT_LE(ticks.size(), 6U) << max;
    EXPECT_EQ(ticks.back(), max);
    const double step = ticks[1] / std::pow(10.0, std::floor(std::log10(ticks[1]) + 1e-9));
    EXPECT_TRUE(std::fabs(step - 1.0) < 1e-9 || std::fabs(step - 2.0) < 1e-9 ||
      std::fabs(step - 2.5) < 1e-9 || std::fabs(step - 5.0) < 1e-9)
      << ticks[1];
  }
}

// Dark pixels of the word stand beside the swatch, and none in it.
TEST_F(CommandThickness, PictureNamesNoneBesideItsSwatch)
{
  run({ "--side", "exterior", "--thickness-image", folder.file("t.png") });
  const auto picture = readPng(folder.file("t.png"));
  const auto count = [&](double left, double right, auto wanted)
  {
    int found = 0;
    for (int y = static_cast<int>(0.14 * 1200) + 1; y < static_cast<int>(0.17 * 1200) - 1; ++y)
    {
      for (int x = static_cast<int>(left * 1600) + 1; x < static_cast<int>(right * 1600) - 1; ++x)
      {
        const double value = picture->GetScalarComponentAsDouble(x, y, 0, 0);
        found += wanted(value) ? 1 : 0;
      }
    }
    return found;
  };
  const auto dark = [](double value) { return value < 120.0; };
  EXPECT_EQ(count(0.844, 0.872, dark), 0);
  EXPECT_GT(count(0.844, 0.872, [](double value) { return value < 220.0; }), 1000);
  EXPECT_GT(count(0.88, 0.97, dark), 50);
}

TEST_F(CommandThickness, OfARealMeshHasAValueAtEveryPoint)
{
  const auto model = modelPath("cad/fandisk_13k.obj");
  if (model)
  {
    input = *model;
  }
  const auto surface = thickness();
  for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
  {
    ASSERT_GE(valueAt(surface, i), 0.0);
  }
}

} // namespace
} // namespace medial::test
