// Axes come back from every format, and damaged files are refused by line and value.
#include "axis_reader.h"
#include "axis_writer.h"
#include "failure.h"
#include "program.h"

#include <vtkCellArray.h>
#include <vtkDataArray.h>
#include <vtkMeshConversion.h>
#include <vtkNew.h>
#include <vtkPointData.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <limits>
#include <set>
#include <string>
#include <vector>

namespace medial::test
{
namespace
{

using app::Failure;
using app::readAxis;

using Cells = std::vector<std::vector<vtkIdType>>;

/// Two quads, a triangle, two lines and two vertices, at places that no format may round.
vtkSmartPointer<vtkPolyData> sample()
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
  auto result = vtkSmartPointer<vtkPolyData>::New();
  vtkMeshConversion::ToPolyData(axis, result);
  return result;
}

Cells cellsOf(vtkCellArray* cells)
{
  Cells result;
  for (vtkIdType cell = 0; cell < cells->GetNumberOfCells(); ++cell)
  {
    vtkIdType count = 0;
    const vtkIdType* ids = nullptr;
    cells->GetCellAtId(cell, count, ids);
    result.emplace_back(ids, ids + count);
  }
  return result;
}

Cells triangulated(const Cells& polygons)
{
  Cells result;
  for (const auto& polygon : polygons)
  {
    for (std::size_t i = 2; i < polygon.size(); ++i)
    {
      result.push_back({ polygon[0], polygon[i - 1], polygon[i] });
    }
  }
  return result;
}

void expectSamePoints(vtkPolyData* read, vtkPolyData* expected)
{
  ASSERT_EQ(read->GetNumberOfPoints(), expected->GetNumberOfPoints());
  for (vtkIdType i = 0; i < read->GetNumberOfPoints(); ++i)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      ASSERT_EQ(read->GetPoint(i)[axis], expected->GetPoint(i)[axis]) << i;
    }
    ASSERT_EQ(read->GetPointData()->GetArray("Radius")->GetTuple1(i),
      expected->GetPointData()->GetArray("Radius")->GetTuple1(i))
      << i;
  }
}

vtkSmartPointer<vtkPolyData> writtenAndRead(vtkPolyData* axis, const std::string& extension)
{
  const TemporaryFolder folder;
  app::writeAxis(axis, folder.file("axis" + extension), extension);
  return readAxis(folder.file("axis" + extension));
}

TEST(AxisReader, VtpPlyAndObjComeBackWhole)
{
  const auto axis = sample();
  for (const char* extension : { ".vtp", ".ply", ".obj" })
  {
    const auto read = writtenAndRead(axis, extension);
    expectSamePoints(read, axis);
    EXPECT_EQ(cellsOf(read->GetPolys()), cellsOf(axis->GetPolys())) << extension;
    EXPECT_EQ(cellsOf(read->GetLines()), cellsOf(axis->GetLines())) << extension;
    EXPECT_EQ(cellsOf(read->GetVerts()), cellsOf(axis->GetVerts())) << extension;
  }
}

TEST(AxisReader, MaComesBackWithQuadsAsTriangles)
{
  const auto axis = sample();
  const auto read = writtenAndRead(axis, ".ma");
  expectSamePoints(read, axis);
  EXPECT_EQ(cellsOf(read->GetPolys()), triangulated(cellsOf(axis->GetPolys())));
  EXPECT_EQ(cellsOf(read->GetLines()), cellsOf(axis->GetLines()));
  EXPECT_EQ(cellsOf(read->GetVerts()), cellsOf(axis->GetVerts()));
}

TEST(AxisReader, EveryKindOfCellComesBackAlone)
{
  const auto axis = sample();
  for (const char* extension : { ".vtp", ".ply", ".obj", ".ma" })
  {
    for (int kind = 0; kind < 3; ++kind)
    {
      vtkNew<vtkPolyData> part;
      part->SetPoints(axis->GetPoints());
      part->GetPointData()->ShallowCopy(axis->GetPointData());
      part->SetPolys(kind == 0 ? axis->GetPolys() : nullptr);
      part->SetLines(kind == 1 ? axis->GetLines() : nullptr);
      part->SetVerts(kind == 2 ? axis->GetVerts() : nullptr);
      const auto read = writtenAndRead(part, extension);
      const bool isMa = std::string(extension) == ".ma";
      const Cells polys = cellsOf(part->GetPolys());
      EXPECT_EQ(cellsOf(read->GetPolys()), isMa ? triangulated(polys) : polys) << extension;
      EXPECT_EQ(cellsOf(read->GetLines()), cellsOf(part->GetLines())) << extension;
    }
  }
}

TEST(AxisReader, VtpAndPlyKeepTheAngles)
{
  const auto axis = sample();
  for (const char* name : { "SeparationAngle", "Lambda" })
  {
    for (const char* extension : { ".vtp", ".ply" })
    {
      const auto read = writtenAndRead(axis, extension);
      vtkDataArray* values = read->GetPointData()->GetArray(name);
      ASSERT_NE(values, nullptr) << name << extension;
      for (vtkIdType i = 0; i < read->GetNumberOfPoints(); ++i)
      {
        EXPECT_EQ(values->GetTuple1(i), axis->GetPointData()->GetArray(name)->GetTuple1(i));
      }
    }
  }
}

vtkSmartPointer<vtkPolyData> readText(const std::string& name, const std::string& content)
{
  const TemporaryFolder folder;
  writeFile(folder.file(name), content);
  return readAxis(folder.file(name));
}

TEST(AxisReader, ReadsWhatOthersWrite)
{
  // Trailing words, comments, blank lines and capitals.
  const auto ma = readText("a.MA",
    "4 4 1\n# made by hand\nv 0 0 0 1.5 0 1\nv 1 0 0 .5\n\nv 0 1 0 1e-3\nv 0 0 1 0\n"
    "e 1 0\ne 0 2\ne 1 2\ne 2 3 7\nf 0 1 2 9\n");
  EXPECT_EQ(ma->GetNumberOfPoints(), 4);
  EXPECT_EQ(cellsOf(ma->GetPolys()), (Cells{ { 0, 1, 2 } }));
  EXPECT_EQ(cellsOf(ma->GetLines()), (Cells{ { 2, 3 } }));
  EXPECT_EQ(ma->GetPointData()->GetArray("Radius")->GetTuple1(0), 1.5);
  const auto ply = readText("a.ply",
    "ply\nformat ascii 1.0\nelement vertex 2\nproperty float x\nproperty float y\n"
    "property float z\nproperty double radius\nend_header\n0 0 0 2\n1 0 0 3\n");
  EXPECT_EQ(cellsOf(ply->GetVerts()), (Cells{ { 0 }, { 1 } }));
  EXPECT_EQ(ply->GetPointData()->GetArray("Radius")->GetTuple1(1), 3.0);
}

// The message for a file that must be refused, without the folder's name.
std::string refusal(const std::string& name, const std::string& content)
{
  const TemporaryFolder folder;
  writeFile(folder.file(name), content);
  try
  {
    readAxis(folder.file(name));
  }
  catch (const Failure& failure)
  {
    EXPECT_EQ(failure.exitCode(), app::ExitCode::BadInput);
    const std::string message = failure.what();
    EXPECT_EQ(message.find(folder.path().string()), 0U) << message;
    EXPECT_EQ(message.find('\n'), std::string::npos) << message;
    return message.substr(folder.path().string().size() + 1);
  }
  ADD_FAILURE() << name << " was accepted";
  return "";
}

TEST(AxisReader, RefusesDamagedMa)
{
  const std::string header = "2 1 0\n";
  const std::string first = "v 0 0 0 1\n";
  EXPECT_EQ(refusal("a.ma", header + first + "v 0 1 0 -2\ne 0 1\n"),
    "a.ma: line 3: radius '-2' is not in [0, infinity)");
  EXPECT_EQ(refusal("a.ma", header + first + "v 0 1 0 nan\ne 0 1\n"),
    "a.ma: line 3: radius 'nan' is not in [0, infinity)");
  EXPECT_EQ(refusal("a.ma", header + first + "v 0 inf 0 1\ne 0 1\n"),
    "a.ma: line 3: 'inf' is not a finite coordinate");
  EXPECT_EQ(refusal("a.ma", header + first + "v 0 1 0\ne 0 1\n"),
    "a.ma: line 3: radius '' is not in [0, infinity)");
  EXPECT_EQ(refusal("a.ma", header + first + "v 0 1 0 1\ne 0 2\n"),
    "a.ma: line 4: point index 2 is outside [0, 1]");
  EXPECT_EQ(refusal("a.ma", header + first + "v 0 1 0 1\ne 0 x\n"),
    "a.ma: line 4: 'x' is not an index");
  EXPECT_EQ(refusal("a.ma", header + first),
    "a.ma: ends early or is damaged: the header promises 2 vertices, the file has 1");
  EXPECT_EQ(refusal("a.ma", header + first + "v 0 1 0 1\n"),
    "a.ma: ends early or is damaged: the header promises 1 edges, the file has 0");
  EXPECT_EQ(refusal("a.ma", header + first + "v 0 1 0 1\ne 0 1\nf 0 1 1\n"),
    "a.ma: is damaged: the header promises 0 faces, the file has 1");
  EXPECT_EQ(refusal("a.ma", header + "w 0 0 0 1\n"), "a.ma: line 2: 'w' is none of v, e, f");
  EXPECT_EQ(refusal("a.ma", "v 0 0 0 1\n"),
    "a.ma: line 1: 'v' is not a count; an .ma file starts with the numbers of vertices, edges and "
    "faces");
  EXPECT_EQ(refusal("a.ma", "0 0 0\n"), "a.ma: holds no points");
}

TEST(AxisReader, RefusesDamagedObj)
{
  const std::string first = "v 0 0 0\n# radius 1\n";
  EXPECT_EQ(refusal("a.obj", first + "v 0 1 0\nv 0 0 1\n# radius 2\n"),
    "a.obj: line 3: a vertex without radius; a line '# radius R' is to follow it");
  EXPECT_EQ(refusal("a.obj", first + "v 0 1 0\n"),
    "a.obj: line 3: a vertex without radius; a line '# radius R' is to follow it");
  EXPECT_EQ(refusal("a.obj", first + "v 0 1 0\n# radius -1\n"),
    "a.obj: line 4: radius '-1' is not in [0, infinity)");
  EXPECT_EQ(refusal("a.obj", first + "v 0 nan 0\n# radius 1\n"),
    "a.obj: line 3: 'nan' is not a finite coordinate");
  EXPECT_EQ(refusal("a.obj", first + "l 1 2\n"), "a.obj: line 3: point index 2 is outside [1, 1]");
}

std::string plyOf(const std::string& vertex)
{
  return "ply\nformat ascii 1.0\nelement vertex 2\nproperty float x\nproperty float y\n"
         "property float z\nproperty float radius\nelement edge 1\nproperty int vertex1\n"
         "property int vertex2\nend_header\n0 0 0 1\n" +
    vertex;
}

TEST(AxisReader, RefusesDamagedPly)
{
  EXPECT_EQ(refusal("a.ply", plyOf("0 1 0 -3\n0 1\n")),
    "a.ply: point 1: radius -3 is outside [0, infinity)");
  EXPECT_EQ(refusal("a.ply", plyOf("0 nan 0 3\n0 1\n")),
    "a.ply: point 1: coordinate nan is not finite");
  EXPECT_EQ(refusal("a.ply", plyOf("0 1 0 1\n0 5\n")), "a.ply: point index 5 is outside [0, 1]");
  EXPECT_NE(refusal("a.ply", plyOf("0 1 0")).find("ends early or is damaged"), std::string::npos);
  EXPECT_EQ(refusal("a.ply",
              "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\n"
              "property float z\nend_header\n0 0 0\n"),
    "a.ply: its vertices have no property 'radius'");
}

TEST(AxisReader, RefusesDamagedVtp)
{
  const TemporaryFolder folder;
  const auto axis = sample();
  app::writeAxis(axis, folder.file("axis.vtp"), ".vtp");
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
    app::writeAxis(bad, folder.file("bad.vtp"), ".vtp");
    return refusal("a.vtp", readFile(folder.file("bad.vtp")));
  };
  EXPECT_EQ(
    written([](vtkPolyData* bad) { bad->GetPointData()->GetArray("Radius")->SetTuple1(3, -0.5); }),
    "a.vtp: point 3: radius -0.5 is outside [0, infinity)");
  EXPECT_EQ(written([](vtkPolyData* bad) { bad->GetPointData()->RemoveArray("Radius"); }),
    "a.vtp: has no point data array Radius of one component");
  EXPECT_EQ(
    written([](vtkPolyData* bad)
      { bad->GetPoints()->SetPoint(2, 0.0, std::numeric_limits<double>::infinity(), 0.0); }),
    "a.vtp: point 2: coordinate inf is not finite");
  EXPECT_NE(written(
              [](vtkPolyData* bad) {
                bad->GetPolys()->InsertNextCell({ 0, 1, 99 });
              })
              .find("point index 99 is outside [0, 12]"),
    std::string::npos);
}

TEST(AxisReader, RefusesFilesThatAreNone)
{
  EXPECT_NE(refusal("a.stl", "").find("unknown extension '.stl', allowed: .vtp .ply .obj .ma"),
    std::string::npos);
  EXPECT_NE(refusal("a.ma", "").find("'' is not a count"), std::string::npos);
  EXPECT_THROW(readAxis("missing.ma"), Failure);
}

// A file cut anywhere is refused or, at a line's end that completes it, read as it is; never more.
TEST(AxisReader, SurvivesEveryTruncation)
{
  const TemporaryFolder folder;
  const auto axis = sample();
  for (const char* extension : { ".ply", ".obj", ".ma" })
  {
    const std::string name = std::string("axis") + extension;
    app::writeAxis(axis, folder.file(name), extension);
    const std::string whole = readFile(folder.file(name));
    int refused = 0;
    for (std::size_t size = 0; size < whole.size(); size += 3)
    {
      writeFile(folder.file(name), whole.substr(0, size));
      try
      {
        EXPECT_LE(readAxis(folder.file(name))->GetNumberOfPoints(), axis->GetNumberOfPoints());
      }
      catch (const Failure&)
      {
        ++refused;
      }
    }
    EXPECT_GT(refused, 50) << extension;
  }
}

} // namespace
} // namespace medial::test
