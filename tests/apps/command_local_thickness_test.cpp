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
  EXPECT_EQ(valueAt(separation, 0.0, 0.0, 0.5), valueAt(both, 0.0, 0.0, 0.5));
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
