// Meshes survive every format, and messages about damaged files name the line and the value.
#include "medial/mesh_io.h"

#include "io/file_reader.h"

#include "medial/error.h"

#include "support/errors.h"
#include "support/files.h"
#include "support/mesh_texts.h"
#include "support/refusal.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <filesystem>
#include <new>
#include <string>
#include <utility>
#include <vector>

namespace medial::test
{
namespace
{

using Ids = std::vector<std::int64_t>;

// Dyadic half sides, so that single precision keeps them.
TriangleMesh sample()
{
  return box({ 2.0, 1.0, 0.5 });
}

MeshInput readText(const std::string& name, const std::string& content)
{
  const TemporaryFolder folder;
  writeFile(folder.file(name), content);
  return readMesh(folder.file(name));
}

// The message for a file that must be refused, without the folder's name.
std::string refusal(const std::string& name, const std::string& content,
  ErrorCode expected = ErrorCode::InvalidInput)
{
  return refusalOf<Error>(
    name, content, [](const std::string& file) { readMesh(file); },
    [&](const Error& error) { EXPECT_EQ(error.code(), expected); });
}

void expectSample(const MeshInput& mesh)
{
  const TriangleMesh expected = sample();
  ASSERT_EQ(mesh.polygons.size(), static_cast<std::int64_t>(expected.triangles.size()));
  for (std::size_t i = 0; i < expected.triangles.size(); ++i)
  {
    ASSERT_EQ(mesh.polygons.offsets[i + 1], static_cast<std::int64_t>(3 * i + 3));
    EXPECT_EQ(mesh.polygons.ids[i], static_cast<std::int64_t>(i));
    for (std::size_t corner = 0; corner < 3; ++corner)
    {
      EXPECT_EQ(mesh.points[mesh.polygons.connectivity[3 * i + corner]],
        expected.points[expected.triangles[i][corner]]);
    }
  }
}

TEST(MeshIo, ReadsEveryTextFormat)
{
  expectSample(readText("a.obj", objText(sample())));
  expectSample(readText("a.off", offText(sample())));
  expectSample(readText("a.ply", plyText(sample())));
  expectSample(readText("a.vtk", vtkText(sample())));
  expectSample(readText("a.stl", stlText(sample())));
}

TEST(MeshIo, ReadsEveryBinaryFormat)
{
  expectSample(readText("a.ply", plyBinary(sample(), false)));
  expectSample(readText("a.ply", plyBinary(sample(), true)));
  expectSample(readText("a.stl", stlBinary(sample())));
}

TEST(MeshIo, StlHasSinglePrecisionAndNoSharedPoints)
{
  TriangleMesh mesh = sample();
  mesh.points[0][0] = 0.1;
  for (const std::string& content : { stlText(mesh), stlBinary(mesh) })
  {
    const MeshInput read = readText("a.stl", content);
    EXPECT_EQ(read.points.size(), 3 * mesh.triangles.size());
    EXPECT_EQ(read.points[read.polygons.connectivity[0]][0],
      static_cast<double>(static_cast<float>(mesh.points[mesh.triangles[0][0]][0])));
    EXPECT_EQ(buildTriangleMesh(read).points.size(), mesh.points.size());
  }
}

TEST(MeshIo, TakesExtensionsInCapitals)
{
  expectSample(readText("a.OFF", offText(sample())));
}

TEST(MeshIo, KeepsDoublePrecisionFarFromTheOrigin)
{
  TriangleMesh mesh = sample();
  for (Point3& point : mesh.points)
  {
    point[0] += 1000000.01;
  }
  for (const auto& [name, text] : { std::pair<std::string, std::string>{ "a.obj", objText(mesh) },
         { "a.off", offText(mesh) }, { "a.ply", plyText(mesh) }, { "a.vtk", vtkText(mesh) } })
  {
    EXPECT_EQ(readText(name, text).points[0], mesh.points[0]) << name;
  }
}

TEST(MeshIo, ReadsPolygonsLinesAndPointsOfObj)
{
  const auto mesh = readText("a.obj",
    "v 0 0 0\nv +1 0 0 # comment\nv 1 1e0 0\nv 0 1 0\nvt 0 0\nvn 0 0 1\n"
    "f 1/1/1 2//1 3/1 \\\n 4\nf -4 -3 -2\nl 1 2 3\np 4 1\nusemtl x\n");
  EXPECT_EQ(mesh.polygons.offsets, (Ids{ 0, 4, 7 }));
  EXPECT_EQ(mesh.polygons.connectivity, (Ids{ 0, 1, 2, 3, 0, 1, 2 }));
  EXPECT_EQ(mesh.lines.connectivity, (Ids{ 0, 1, 2 }));
  EXPECT_EQ(mesh.verts.connectivity, (Ids{ 3, 0 }));
  // As VTK counts cells: vertices, lines, polygons.
  EXPECT_EQ(mesh.verts.ids, (Ids{ 0 }));
  EXPECT_EQ(mesh.lines.ids, (Ids{ 1 }));
  EXPECT_EQ(mesh.polygons.ids, (Ids{ 2, 3 }));
}

TEST(MeshIo, ReadsColouredOffAndEdgesOfPly)
{
  const auto off = readText("a.off",
    "COFF\n3 1 0\n0 0 0 255 0 0 255\n1 0 0 0 0 0 0\n0 1 0 1 1 1 1\n3 0 1 2 9 9 9\n");
  EXPECT_EQ(off.polygons.size(), 1);
  EXPECT_EQ(off.points[2], (Point3{ 0.0, 1.0, 0.0 }));
  const auto ply = readText("a.ply",
    "ply\nformat ascii 1.0\nelement vertex 2\nproperty float x\nproperty float y\nproperty float "
    "z\nelement edge 1\nproperty int vertex1\nproperty int vertex2\nend_header\n0 0 0\n1 2 3\n0 "
    "1\n");
  EXPECT_EQ(ply.lines.connectivity, (Ids{ 0, 1 }));
}

TEST(MeshIo, ReadsLegacyVtkWithOffsetsStripsAndFields)
{
  const auto mesh = readText("a.vtk",
    "# vtk DataFile Version 5.1\nt\nASCII\nDATASET POLYDATA\nFIELD FieldData 1\nt 1 1 double\n0.5\n"
    "POINTS 4 float\n0 0 0 1 0 0 0 1 0 1 1 0\nMETADATA\nINFORMATION 0\n\n"
    "POLYGONS 2 3\nOFFSETS vtktypeint64\n0 3\nCONNECTIVITY vtktypeint64\n0 1 2\n"
    "TRIANGLE_STRIPS 1 5\n4 0 1 2 3\nPOINT_DATA 4\nSCALARS s float 1\n");
  EXPECT_EQ(mesh.polygons.connectivity, (Ids{ 0, 1, 2 }));
  EXPECT_EQ(mesh.strips.connectivity, (Ids{ 0, 1, 2, 3 }));
  EXPECT_EQ(mesh.strips.ids, (Ids{ 1 }));
}

TEST(MeshIo, RefusesWhatIsNoMeshFile)
{
  EXPECT_EQ(refusal("a.step", "1", ErrorCode::CannotRead),
    "a.step: unknown extension '.step', allowed: .stl .obj .ply .off .vtk");
  for (const char* name : { "a.stl", "a.obj", "a.ply", "a.off", "a.vtk" })
  {
    EXPECT_NE(refusal(name, ""), "") << name;
    EXPECT_NE(refusal(name, "this is not a mesh\n"), "") << name;
    EXPECT_NE(refusal(name, std::string(300, '\0')), "") << name;
  }
}

TEST(MeshIo, RefusesWhatCannotBeRead)
{
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder.file("folder.obj"));
  for (const std::string& path : { folder.file("missing.obj"), folder.file("folder.obj") })
  {
    const std::string message = messageOf([&] { readMesh(path); }, ErrorCode::CannotRead);
    EXPECT_EQ(message.rfind(path + ": ", 0), 0U) << message;
  }
}

TEST(MeshIo, KnowsItsExtensions)
{
  EXPECT_TRUE(isMeshFile("a.obj") && isMeshFile("a.PLY") && isMeshFile("a.off"));
  EXPECT_TRUE(isMeshFile("folder.d/a.vtk") && isMeshFile("a.STL"));
  EXPECT_FALSE(isMeshFile("a.step") || isMeshFile("a.vtp") || isMeshFile("obj"));
}

TEST(MeshIo, RefusesFilesThatEndEarly)
{
  const std::vector<std::pair<std::string, std::string>> files = { { "a.off", offText(sample()) },
    { "a.ply", plyText(sample()) }, { "b.ply", plyBinary(sample(), false) },
    { "c.ply", plyBinary(sample(), true) }, { "a.vtk", vtkText(sample()) },
    { "a.stl", stlText(sample()) }, { "b.stl", stlBinary(sample()) } };
  for (const auto& [name, content] : files)
  {
    for (const double share : { 0.1, 0.4, 0.7, 0.95 })
    {
      const auto length = static_cast<std::size_t>(share * static_cast<double>(content.size()));
      EXPECT_NE(refusal(name, content.substr(0, length)), "") << name << ' ' << share;
    }
  }
}

TEST(MeshIo, NamesTheCountsOfTruncatedFiles)
{
  EXPECT_NE(refusal("a.ply", plyText(sample(), 100)).find("promises 100 'face', number 13"),
    std::string::npos);
}

// Text that is no STL was taken for a binary file, whose number of triangles is the text itself.
TEST(MeshIo, RefusesDamagedStlTextByLine)
{
  const std::string start = "solid s\nfacet normal 0 0 1\n outer loop\n";
  EXPECT_EQ(refusal("a.stl", start + "  vertex 0 0 zero\n"),
    "a.stl: line 4: 'zero' in place of a coordinate");
  EXPECT_EQ(refusal("a.stl", start + "  vertex 0 0 0\n endloop\n"),
    "a.stl: line 5: 'endloop' in place of vertex");
  EXPECT_EQ(refusal("a.stl", start), "a.stl: line 4: '' in place of vertex: the file ends early");
  EXPECT_EQ(refusal("a.stl", "solid s\n"), "a.stl: ends early: its last solid has no 'endsolid'");
  EXPECT_EQ(refusal("a.stl", "solid s\nfact\n"),
    "a.stl: line 2: 'fact' in place of facet or endsolid");
  EXPECT_NE(refusal("a.stl", "solid \xff" + std::string(200, ' ')), "");
}

TEST(MeshIo, ReadsSeveralSolidsOfOneStlTextInAnyCase)
{
  const std::string facet = "FACET NORMAL nan nan nan\r\nOUTER LOOP\r\nVERTEX +0 0 0\r\n"
                            "VERTEX 1e0 0 0\r\nVERTEX 0 1 0\r\nENDLOOP\r\nENDFACET\r\n";
  const std::string content =
    "solid first one\r\n" + facet + "ENDSOLID first one\r\nSOLID\r\n" + facet + "ENDSOLID\r\n";
  EXPECT_EQ(readText("a.stl", content).polygons.size(), 2);
}

TEST(MeshIo, ReadsStlTextThatDoesNotBeginWithItsFirstWord)
{
  const std::string solid = "SOLID s\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\n"
                            "vertex 0 1 0\nendloop\nendfacet\nendsolid s\n";
  for (const char* before : { "", "\n", " \t\r\n ", "\xEF\xBB\xBF" })
  {
    EXPECT_EQ(readText("a.stl", before + solid).polygons.size(), 1);
  }
}

TEST(MeshIo, RefusesPointsThatDoNotExist)
{
  TriangleMesh mesh = sample();
  mesh.triangles[3][1] = 99;
  const std::string expected = "point index 99 is outside [0, 7]";
  EXPECT_NE(refusal("a.off", offText(mesh)).find(expected), std::string::npos);
  EXPECT_NE(refusal("a.ply", plyText(mesh)).find(expected), std::string::npos);
  EXPECT_NE(refusal("a.vtk", vtkText(mesh)).find(expected), std::string::npos);
  EXPECT_NE(refusal("a.obj", objText(mesh)).find("line 14: point index 100 is outside [1, 8]"),
    std::string::npos);
  mesh.triangles[3][1] = -2;
  EXPECT_NE(refusal("a.ply", plyText(mesh)).find("point index -2"), std::string::npos);
  EXPECT_NE(refusal("a.obj", "v 0 0 0\nf 0 1 1\n").find("line 2: '0'"), std::string::npos);
  EXPECT_NE(refusal("a.obj", "v 0 0 0\nf -2 1 1\n").find("line 2: '-2'"), std::string::npos);
}

TEST(MeshIo, RefusesWordsForNumbers)
{
  EXPECT_EQ(refusal("a.obj", "v 0 0 0\n"), "a.obj: holds no faces, lines or vertices");
  EXPECT_EQ(refusal("a.obj", "v 0 0 0\nf\n"), "a.obj: line 2: a cell without points");
  EXPECT_EQ(refusal("a.obj", "v 0 zero 0\n"), "a.obj: line 1: 'zero' is not a coordinate");
  EXPECT_NE(refusal("a.off", "OFF\n1 0 0\n0 0 x\n").find("line 3"), std::string::npos);
}

TEST(MeshIo, RefusesHugeCountsWithoutHugeMemory)
{
  EXPECT_NE(refusal("a.off", "OFF\n4000000000000 1 0\n0 0 0\n"), "");
  EXPECT_NE(refusal("a.vtk",
              "# vtk DataFile Version 3.0\nt\nASCII\nDATASET POLYDATA\n"
              "POINTS 4000000000000000000 float\n0 0 0\n"),
    "");
  EXPECT_NE(refusal("a.ply",
              "ply\nformat ascii 1.0\nelement vertex 9000000000000000000\nproperty float x\n"
              "property float y\nproperty float z\nend_header\n0 0 0\n"),
    "");
}

TEST(MeshIo, RefusesOtherDataSets)
{
  EXPECT_NE(refusal("a.vtk",
              "# vtk DataFile Version 3.0\nt\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 0 float\n")
              .find("UNSTRUCTURED_GRID"),
    std::string::npos);
}

TEST(MeshIo, MessagesQuoteNothingThatATerminalWouldObey)
{
  EXPECT_EQ(refusal("a.off", "\x1b[31mOF\n"),
    "a.off: not a three-dimensional OFF file: it starts with '?[31mOF'");
  EXPECT_EQ(refusal("a.obj", "v 0 0 " + std::string(100000, 'x')).size(), 7U + 300U + 3U);
}

TEST(MeshIo, NamesTheFileThatDoesNotFitIntoMemory)
{
  EXPECT_EQ(refusalOf<Error>(
              "a.obj", "v 0 0 0\n",
              [](const std::string& file)
              {
                medial::readFile(file,
                  [](const std::filesystem::path&) -> MeshInput { throw std::bad_alloc(); });
              },
              [](const Error& error) { EXPECT_EQ(error.code(), ErrorCode::OutOfMemory); }),
    "a.obj: not enough memory");
}

// As Cyberware's scans and those of Stanford come; -1 ends a strip.
TEST(MeshIo, PlyMayHoldTriangleStrips)
{
  const MeshInput mesh = readText("a.ply",
    "ply\nformat ascii 1.0\nelement vertex 5\n"
    "property float x\nproperty float y\nproperty float z\n"
    "element tristrips 1\n"
    "property list int int vertex_indices\nend_header\n"
    "0 0 0\n1 0 0\n0 1 0\n1 1 0\n2 2 2\n"
    "8 0 1 2 3 -1 2 3 4\n");
  ASSERT_EQ(mesh.strips.size(), 2);
  EXPECT_EQ(mesh.strips.connectivity, (Ids{ 0, 1, 2, 3, 2, 3, 4 }));
  EXPECT_EQ(buildTriangleMesh(mesh).triangles.size(), 3U);
}

TEST(MeshIo, AnEmptyFileIsCalledEmpty)
{
  EXPECT_EQ(refusal("a.ply", ""), "a.ply: the file is empty");
}

} // namespace
} // namespace medial::test
