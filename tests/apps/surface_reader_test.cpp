#include "failure.h"
#include "input/surface_reader.h"

#include "support/files.h"
#include "support/mesh_texts.h"
#include "support/refusal.h"
#include "support/shapes.h"

#include <vtkCellArray.h>
#include <vtkXMLPolyDataWriter.h>

#include <gtest/gtest.h>

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace medial::test
{
namespace
{

using app::Failure;
using app::readSurface;

// Dyadic half sides, so that single precision keeps them.
TriangleMesh sample()
{
  return box({ 2.0, 1.0, 0.5 });
}

vtkSmartPointer<vtkPolyData> readText(const std::string& name, const std::string& content)
{
  const TemporaryFolder folder;
  writeFile(folder.file(name), content);
  return readSurface(folder.file(name)).polyData();
}

// The message for a file that must be refused, without the folder's name.
std::string refusal(const std::string& name, const std::string& content)
{
  return refusalOf<Failure>(
    name, content, [](const std::string& file) { readSurface(file); },
    [](const Failure& failure) { EXPECT_EQ(failure.exitCode(), app::ExitCode::BadInput); });
}

void expectSample(vtkPolyData* mesh)
{
  const TriangleMesh expected = sample();
  ASSERT_EQ(mesh->GetNumberOfPolys(), static_cast<vtkIdType>(expected.triangles.size()));
  vtkIdType count = 0;
  const vtkIdType* ids = nullptr;
  for (std::size_t i = 0; i < expected.triangles.size(); ++i)
  {
    mesh->GetPolys()->GetCellAtId(static_cast<vtkIdType>(i), count, ids);
    ASSERT_EQ(count, 3);
    for (int corner = 0; corner < 3; ++corner)
    {
      const Point3& point = expected.points[expected.triangles[i][corner]];
      const double* read = mesh->GetPoint(ids[corner]);
      EXPECT_EQ((Point3{ read[0], read[1], read[2] }), point);
    }
  }
}

TEST(SurfaceReader, ReadsEveryTextFormat)
{
  expectSample(readText("a.obj", objText(sample())));
  expectSample(readText("a.off", offText(sample())));
  expectSample(readText("a.ply", plyText(sample())));
  expectSample(readText("a.stl", stlText(sample())));
  expectSample(readText("a.vtk", vtkText(sample())));
}

TEST(SurfaceReader, ReadsEveryBinaryFormat)
{
  expectSample(readText("a.ply", plyBinary(sample(), false)));
  expectSample(readText("a.ply", plyBinary(sample(), true)));
  expectSample(readText("a.stl", stlBinary(sample())));
}

TEST(SurfaceReader, ReadsWhatVtkWrites)
{
  const TemporaryFolder folder;
  vtkSmartPointer<vtkPolyData> mesh = readText("a.obj", objText(sample()));
  vtkNew<vtkXMLPolyDataWriter> writer;
  writer->SetInputData(mesh);
  writer->SetFileName(folder.file("a.vtp").c_str());
  writer->Write();
  expectSample(readSurface(folder.file("a.vtp")).polyData());
}

TEST(SurfaceReader, TakesExtensionsInCapitals)
{
  expectSample(readText("a.OFF", offText(sample())));
}

TEST(SurfaceReader, KeepsDoublePrecisionFarFromTheOrigin)
{
  TriangleMesh mesh = sample();
  for (Point3& point : mesh.points)
  {
    point[0] += 1000000.01;
  }
  for (const auto& [name, text] : { std::pair<std::string, std::string>{ "a.obj", objText(mesh) },
         { "a.off", offText(mesh) }, { "a.ply", plyText(mesh) }, { "a.vtk", vtkText(mesh) } })
  {
    EXPECT_EQ(readText(name, text)->GetPoint(0)[0], mesh.points[0][0]) << name;
  }
}

TEST(SurfaceReader, ReadsLegacyVtkWithOffsetsStripsAndFields)
{
  const auto mesh = readText("a.vtk",
    "# vtk DataFile Version 5.1\nt\nASCII\nDATASET POLYDATA\nFIELD FieldData 1\nt 1 1 double\n0.5\n"
    "POINTS 4 float\n0 0 0 1 0 0 0 1 0 1 1 0\nMETADATA\nINFORMATION 0\n\n"
    "POLYGONS 2 3\nOFFSETS vtktypeint64\n0 3\nCONNECTIVITY vtktypeint64\n0 1 2\n"
    "TRIANGLE_STRIPS 1 5\n4 0 1 2 3\nPOINT_DATA 4\nSCALARS s float 1\n");
  EXPECT_EQ(mesh->GetNumberOfPolys(), 1);
  EXPECT_EQ(mesh->GetNumberOfStrips(), 1);
}

// The library gets the cells that VTK sees, under the ids that VTK gives them.
TEST(SurfaceReader, LibraryAndVtkSeeTheSameCells)
{
  const TemporaryFolder folder;
  writeFile(folder.file("a.vtk"),
    "# vtk DataFile Version 3.0\nt\nASCII\nDATASET POLYDATA\nPOINTS 5 double\n"
    "0 0 0 1 0 0 0 1 0 1 1 0 2 2 2\nPOLYGONS 1 5\n4 0 1 3 2\nLINES 1 4\n3 0 1 4\n"
    "TRIANGLE_STRIPS 1 5\n4 0 1 2 3\nVERTICES 1 2\n1 4\n");
  app::Surface read = readSurface(folder.file("a.vtk"));
  vtkNew<vtkXMLPolyDataWriter> writer;
  writer->SetInputData(read.polyData());
  writer->SetFileName(folder.file("a.vtp").c_str());
  writer->Write();
  const TriangleMesh expected = readSurface(folder.file("a.vtp")).toTriangleMesh();
  const TriangleMesh mesh = read.toTriangleMesh();
  EXPECT_EQ(mesh.points, expected.points);
  EXPECT_EQ(mesh.triangles, expected.triangles);
  EXPECT_EQ(mesh.triangleCells, (std::vector<std::int64_t>{ 2, 2, 3, 3 }));
  EXPECT_EQ(mesh.triangleCells, expected.triangleCells);
  EXPECT_EQ(mesh.segmentCells, expected.segmentCells);
  EXPECT_EQ(mesh.vertexCells, expected.vertexCells);
}

TEST(SurfaceReader, RefusesWhatIsNoMeshFile)
{
  EXPECT_EQ(refusal("a.xyz", "1"),
    "a.xyz: unknown extension '.xyz', allowed: .stl .obj .ply .off .vtp .vtk");
  for (const char* name : { "a.stl", "a.obj", "a.ply", "a.off", "a.vtp", "a.vtk" })
  {
    EXPECT_NE(refusal(name, ""), "") << name;
    EXPECT_NE(refusal(name, "this is not a mesh\n"), "") << name;
    EXPECT_NE(refusal(name, std::string(300, '\0')), "") << name;
  }
}

TEST(SurfaceReader, RefusesFilesThatEndEarly)
{
  const std::vector<std::pair<std::string, std::string>> files = { { "a.off", offText(sample()) },
    { "a.ply", plyText(sample()) }, { "b.ply", plyBinary(sample(), false) },
    { "c.ply", plyBinary(sample(), true) }, { "a.stl", stlText(sample()) },
    { "b.stl", stlBinary(sample()) }, { "a.vtk", vtkText(sample()) } };
  for (const auto& [name, content] : files)
  {
    for (const double share : { 0.1, 0.4, 0.7, 0.95 })
    {
      const auto length = static_cast<std::size_t>(share * static_cast<double>(content.size()));
      EXPECT_NE(refusal(name, content.substr(0, length)), "") << name << ' ' << share;
    }
  }
}

TEST(SurfaceReader, NamesTheCountsOfTruncatedFiles)
{
  const std::string stl = stlBinary(sample());
  EXPECT_NE(refusal("a.stl", stl.substr(0, stl.size() - 70)).find("12 triangles"),
    std::string::npos);
  EXPECT_NE(refusal("a.ply", plyText(sample(), 100)).find("promises 100 'face', number 13"),
    std::string::npos);
}

TEST(SurfaceReader, CharactersThatATerminalWouldObeyAreNotPrinted)
{
  EXPECT_EQ(refusal("a.off", "\x1b[31mOF\n"),
    "a.off: not a three-dimensional OFF file: it starts with '?[31mOF'");
  EXPECT_EQ(refusal("a.stl", "solid s\n\x1b[31m\n"),
    "a.stl: line 2: '?[31m' in place of facet or endsolid");
  EXPECT_LT(refusal("a.obj", "v 0 0 " + std::string(100000, 'x')).size(), 320U);
}

} // namespace
} // namespace medial::test
