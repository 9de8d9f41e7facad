// Models of balls come from every format of axes, and messages about damaged files name point and
// value.
#include "failure.h"
#include "input/model_reader.h"
#include "output/vtp_writer.h"

#include "medial/axis_io.h"

#include "support/files.h"
#include "support/refusal.h"

#include <vtkCellArray.h>
#include <vtkDataArray.h>
#include <vtkDoubleArray.h>
#include <vtkMeshConversion.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <gtest/gtest.h>

#include <functional>
#include <limits>
#include <string>
#include <vector>

namespace medial::test
{
namespace
{

using app::Failure;
using app::readModel;

/// Two quads, a triangle, two lines and two vertices, with coordinates that no format may round.
MedialAxis sampleAxis()
{
  MedialAxis axis;
  for (int i = 0; i < 13; ++i)
  {
    axis.points.push_back({ 1000000.01 + 0.1 * i, (i % 3) / 3.0, -1e-9 * i * i });
    axis.radius.push_back(0.1F + 0.3F * static_cast<float>(i));
    axis.separationAngle.push_back(180.0F / static_cast<float>(i + 1));
    axis.lambda.push_back(0.05F * static_cast<float>(i));
    axis.feature.push_back(AxisFeature::Sheet);
    axis.closestPointA.push_back({ 1.0F, 2.0F, 3.0F });
    axis.closestPointB.push_back({ 4.0F, 5.0F, 6.0F });
  }
  axis.quads = { { 0, 1, 3, 2 }, { 2, 3, 5, 4 } };
  axis.triangles = { { 4, 5, 6 } };
  axis.lines = { { 6, 7 }, { 8, 9 } };
  axis.vertices = { 10, 11, 12 };
  return axis;
}

vtkSmartPointer<vtkPolyData> sample()
{
  auto result = vtkSmartPointer<vtkPolyData>::New();
  vtkMeshConversion::ToPolyData(sampleAxis(), result);
  return result;
}

MedialModel writtenAndRead(const MedialAxis& axis, const std::string& extension)
{
  const TemporaryFolder folder;
  const std::string file = folder.file("axis" + extension);
  if (extension == ".vtp")
  {
    vtkNew<vtkPolyData> data;
    vtkMeshConversion::ToPolyData(axis, data);
    app::writeVtp(data, file);
  }
  else
  {
    writeAxis(axis, file);
  }
  return readModel(file);
}

void expectSameBalls(const MedialModel& read, const MedialAxis& axis, const std::string& extension)
{
  EXPECT_EQ(read.centres, axis.points) << extension;
  EXPECT_EQ(read.radii, std::vector<double>(axis.radius.begin(), axis.radius.end())) << extension;
}

TEST(ModelReader, VtpPlyAndObjComeBackWhole)
{
  const MedialAxis axis = sampleAxis();
  for (const char* extension : { ".vtp", ".ply", ".obj" })
  {
    const MedialModel read = writtenAndRead(axis, extension);
    expectSameBalls(read, axis, extension);
    EXPECT_EQ(read.quads, axis.quads) << extension;
    EXPECT_EQ(read.triangles, axis.triangles) << extension;
    EXPECT_EQ(read.lines, axis.lines) << extension;
    EXPECT_EQ(read.vertices, axis.vertices) << extension;
  }
}

TEST(ModelReader, MaComesBackWithQuadsAsTriangles)
{
  const MedialAxis axis = sampleAxis();
  const MedialModel read = writtenAndRead(axis, ".ma");
  expectSameBalls(read, axis, ".ma");
  EXPECT_TRUE(read.quads.empty());
  EXPECT_EQ(read.triangles.size(), 2 * axis.quads.size() + axis.triangles.size());
  EXPECT_EQ(read.lines, axis.lines);
  EXPECT_EQ(read.vertices, axis.vertices);
}

// Of VTP files only the axes of this program have float radii.
TEST(ModelReader, RadiiOfVtpHaveSinglePrecision)
{
  const TemporaryFolder folder;
  const auto axis = sample();
  vtkNew<vtkDoubleArray> radius;
  radius->SetName("Radius");
  for (vtkIdType i = 0; i < axis->GetNumberOfPoints(); ++i)
  {
    radius->InsertNextValue(0.1);
  }
  axis->GetPointData()->AddArray(radius);
  app::writeVtp(axis, folder.file("axis.vtp"));
  EXPECT_EQ(readModel(folder.file("axis.vtp")).radii[0], static_cast<double>(0.1F));
}

// The message for a file that must be refused, without the folder's name.
std::string refusal(const std::string& name, const std::string& content)
{
  return refusalOf<Failure>(
    name, content, [](const std::string& file) { readModel(file); },
    [](const Failure& failure) { EXPECT_EQ(failure.exitCode(), app::ExitCode::BadInput); });
}

TEST(ModelReader, RefusesDamagedVtp)
{
  const TemporaryFolder folder;
  const auto axis = sample();
  app::writeVtp(axis, folder.file("axis.vtp"));
  const std::string whole = readFile(folder.file("axis.vtp"));
  for (const double share : { 0.1, 0.5, 0.9 })
  {
    const auto size = static_cast<std::size_t>(share * static_cast<double>(whole.size()));
    refusal("a.vtp", whole.substr(0, size));
  }
  const auto written = [&](const std::function<void(vtkPolyData*)>& spoil)
  {
    const auto bad = sample();
    spoil(bad);
    app::writeVtp(bad, folder.file("bad.vtp"));
    return refusal("a.vtp", readFile(folder.file("bad.vtp")));
  };
  EXPECT_EQ(
    written([](vtkPolyData* bad) { bad->GetPointData()->GetArray("Radius")->SetTuple1(3, -0.5); }),
    "a.vtp: point 3: radius -0.5 is outside [0, 1e+100]");
  EXPECT_EQ(written([](vtkPolyData* bad) { bad->GetPointData()->RemoveArray("Radius"); }),
    "a.vtp: has no point data array Radius of one component");
  EXPECT_EQ(
    written([](vtkPolyData* bad)
      { bad->GetPoints()->SetPoint(2, 0.0, std::numeric_limits<double>::infinity(), 0.0); }),
    "a.vtp: point 2: coordinate inf is outside [-1e+100, 1e+100]");
  EXPECT_NE(written(
              [](vtkPolyData* bad) {
                bad->GetPolys()->InsertNextCell({ 0, 1, 99 });
              })
              .find("point index 99 is outside [0, 12]"),
    std::string::npos);
}

TEST(ModelReader, RefusesDamagedFilesOfTheLibrarysFormats)
{
  EXPECT_EQ(refusal("a.ma", "1 0 0\nv 0 0 0 -1\n"),
    "a.ma: line 2: radius '-1' is outside [0, infinity)");
  EXPECT_EQ(refusal("a.obj", "v 0 0 1e200\n# radius 1\n"),
    "a.obj: point 0: coordinate 1e+200 is outside [-1e+100, 1e+100]");
}

TEST(ModelReader, RefusesFilesThatAreNone)
{
  EXPECT_EQ(refusal("a.stl", ""), "a.stl: unknown extension '.stl', allowed: .vtp .ply .obj .ma");
  EXPECT_NE(refusal("a.ma", "").find("'' is not a count"), std::string::npos);
  EXPECT_THROW(readModel("missing.ma"), Failure);
  EXPECT_THROW(readModel("missing.vtp"), Failure);
}

} // namespace
} // namespace medial::test
