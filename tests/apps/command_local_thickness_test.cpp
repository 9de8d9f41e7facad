// What the program does for --local-thickness.
#include "command_run.h"

#include "support/shapes.h"

#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkPointData.h>
#include <vtkSmartPointer.h>
#include <vtkXMLImageDataReader.h>

#include <cstdint>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace medial::test
{
namespace
{

class CommandLocalThickness : public CommandRun
{
protected:
  CommandLocalThickness()
    : CommandRun(box({ 1.0, 0.7, 0.4 }))
  {
  }

  vtkSmartPointer<vtkImageData> image(std::vector<std::string> arguments = {}) const
  {
    arguments.insert(arguments.end(),
      { "--resolution", "32", "--local-thickness", folder.file("t.vti") });
    run(arguments);
    return readWith<vtkXMLImageDataReader>(folder.file("t.vti"));
  }
};

double valueAt(vtkImageData* image, double x, double y, double z)
{
  const vtkIdType point = image->FindPoint(x, y, z);
  return image->GetPointData()->GetArray("LocalThickness")->GetTuple1(point);
}

/// First and last column of a picture's pixels of a kind; -1 where there are none.
template <typename Wanted>
std::pair<int, int> columnsOf(vtkImageData* picture, const Wanted& wanted)
{
  std::pair<int, int> columns{ -1, -1 };
  const int* const size = picture->GetDimensions();
  for (int x = 0; x < size[0]; ++x)
  {
    for (int y = 0; y < size[1]; ++y)
    {
      double rgb[3];
      for (int c = 0; c < 3; ++c)
      {
        rgb[c] = picture->GetScalarComponentAsDouble(x, y, 0, c);
      }
      if (wanted(rgb[0], rgb[1], rgb[2]))
      {
        columns = { columns.first < 0 ? x : columns.first, x };
        break;
      }
    }
  }
  return columns;
}

std::pair<int, int> blueOf(vtkImageData* picture)
{
  return columnsOf(picture, [](double r, double, double b) { return b > r + 60.0; });
}

} // namespace

TEST_F(CommandLocalThickness, IsAnImageWithZeroOutside)
{
  const auto thickness = image();
  EXPECT_EQ(thickness->GetPointData()->GetNumberOfArrays(), 1);
  EXPECT_NEAR(valueAt(thickness, 0.0, 0.0, 0.3), 0.8, 0.01);
  EXPECT_EQ(valueAt(thickness, 0.0, 0.0, 0.5), 0.0);
}

TEST_F(CommandLocalThickness, ObeysTheSide)
{
  const auto both = image({ "--side", "both" });
  EXPECT_NEAR(valueAt(both, 0.0, 0.0, 0.3), 0.8, 0.01);
  EXPECT_LT(valueAt(both, 0.0, 0.0, 0.5), 0.0);
  const auto separation = image({ "--side", "exterior" });
  EXPECT_EQ(valueAt(separation, 0.0, 0.0, 0.3), 0.0);
  EXPECT_EQ(valueAt(separation, 0.0, 0.0, 0.5), -valueAt(both, 0.0, 0.0, 0.5));
}

TEST_F(CommandLocalThickness, ComesWithTheField)
{
  image({ "--field", folder.file("both.vti"), "--report", folder.file("r.json") });
  const auto report = Json::parse(readFile(folder.file("r.json")));
  EXPECT_EQ(report["sign_method"], "winding");
  run({ "--resolution", "32", "--field", folder.file("alone.vti") });
  EXPECT_EQ(readFile(folder.file("both.vti")), readFile(folder.file("alone.vti")));
}

TEST_F(CommandLocalThickness, HistogramMarksMeanAndDeviation)
{
  image({ "--histogram", folder.file("h.png"), "--report", folder.file("r.json") });
  const auto report = Json::parse(readFile(folder.file("r.json")));
  const auto& thickness = report["local_thickness"]["thickness"];
  const auto picture = readPng(folder.file("h.png"));
  const auto red = columnsOf(picture,
    [](double r, double g, double b) { return r > 150.0 && g < 60.0 && b < 60.0; });
  const auto orange = columnsOf(picture,
    [](double r, double g, double b) { return r > 200.0 && g > 120.0 && b < 60.0; });
  ASSERT_GE(red.first, 0);
  ASSERT_GE(orange.first, 0);
  EXPECT_LT(red.second - red.first, 10);
  // From the lower end of the deviation to that of the axis.
  const double deviation = thickness["standard_deviation"];
  const double all =
    thickness["histogram_end"].get<double>() - (thickness["mean"].get<double>() - deviation);
  EXPECT_NEAR(0.5 * (red.first + red.second) - orange.first,
    deviation / all * (blueOf(picture).second - orange.first), 4.0);
}

TEST_F(CommandLocalThickness, HistogramShowsBothSides)
{
  image({ "--side", "interior", "--histogram", folder.file("one.png") });
  image({ "--side", "both", "--histogram", folder.file("two.png") });
  const auto darkRows = [](vtkImageData* picture)
  {
    int rows = 0; // from left to right: those of axes
    const int* const size = picture->GetDimensions();
    for (int y = 0; y < size[1]; ++y)
    {
      int dark = 0;
      for (int x = 0; x < size[0]; ++x)
      {
        dark += picture->GetScalarComponentAsDouble(x, y, 0, 2) < 100.0 ? 1 : 0;
      }
      rows += dark > size[0] * 8 / 10 ? 1 : 0;
    }
    return rows;
  };
  const int one = darkRows(readPng(folder.file("one.png")));
  EXPECT_GT(one, 0);
  EXPECT_EQ(darkRows(readPng(folder.file("two.png"))), 2 * one);
}

// A mean of nothing would be no number.
TEST_F(CommandLocalThickness, SaysWhereNoGridPointIsInside)
{
  const Outcome outcome = runMedialAxis({ input, "--resolution", "3", "--padding", "0",
    "--local-thickness", folder.file("t.vti"), "--side", "both" });
  EXPECT_EQ(outcome.exitCode, 0) << outcome.err;
  EXPECT_TRUE(contains(outcome.out, "local     thickness: no grid point lies inside the surface\n"))
    << outcome.out;
  EXPECT_FALSE(contains(outcome.out, "nan")) << outcome.out;
}

TEST_F(CommandLocalThickness, HistogramNeedsLocalThickness)
{
  const Outcome outcome = runMedialAxis({ input, "--histogram", folder.file("h.png") });
  EXPECT_EQ(outcome.exitCode, 2);
  EXPECT_NE(outcome.err.find("--local-thickness"), std::string::npos) << outcome.err;
}

TEST_F(CommandLocalThickness, ReportHasItsDistribution)
{
  image({ "--report", folder.file("r.json") });
  const auto report = Json::parse(readFile(folder.file("r.json")));
  const auto& thickness = report["local_thickness"]["thickness"];
  EXPECT_TRUE(report["local_thickness"]["separation"].is_null());
  EXPECT_GT(thickness["mean"].get<double>(), 0.6);
  EXPECT_LT(thickness["mean"].get<double>(), thickness["max"].get<double>());
  EXPECT_NEAR(thickness["max"].get<double>(), 0.8, 0.01);
  std::int64_t points = 0;
  for (const auto& count : thickness["histogram"])
  {
    points += count.get<std::int64_t>();
  }
  EXPECT_EQ(points, thickness["points"].get<std::int64_t>());
  EXPECT_EQ(report["sign_method"], "winding");
}

TEST_F(CommandLocalThickness, WithoutASignWritesNothing)
{
  const Outcome outcome = runMedialAxis(
    { input, "--resolution", "16", "--sign", "none", "--local-thickness", folder.file("t.vti") });
  EXPECT_EQ(outcome.exitCode, 3);
  EXPECT_NE(outcome.err.find("local thickness needs an inside"), std::string::npos);
  EXPECT_FALSE(std::filesystem::exists(folder.file("t.vti")));
}

} // namespace medial::test
