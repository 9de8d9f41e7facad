// Axes survive every format, and messages about damaged files name the line and the value.
#include "medial/axis_io.h"

#include "medial/error.h"

#include "support/errors.h"
#include "support/files.h"
#include "support/refusal.h"

#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <filesystem>
#include <ostream>
#include <sstream>
#include <string>
#include <vector>

namespace medial::test
{
namespace
{

using Triangles = std::vector<std::array<std::int64_t, 3>>;
using Lines = std::vector<std::array<std::int64_t, 2>>;
using Ids = std::vector<std::int64_t>;

constexpr std::array<const char*, 3> kExtensions = { ".ply", ".obj", ".ma" };

/// Two quads, a triangle, two lines and two vertices, with coordinates that no format may round.
MedialAxis sample()
{
  MedialAxis axis;
  for (int i = 0; i < 13; ++i)
  {
    axis.points.push_back({ 1000000.01 + 0.1 * i, (i % 3) / 3.0, -1e-9 * i * i });
    axis.radius.push_back(0.1F + 0.3F * static_cast<float>(i));
    axis.separationAngle.push_back(180.0F / static_cast<float>(i + 1));
    axis.lambda.push_back(0.05F * static_cast<float>(i));
  }
  axis.quads = { { 0, 1, 3, 2 }, { 2, 3, 5, 4 } };
  axis.triangles = { { 4, 5, 6 } };
  axis.lines = { { 6, 7 }, { 8, 9 } };
  axis.vertices = { 10, 11, 12 };
  return axis;
}

Triangles triangulated(const MedialAxis& axis)
{
  Triangles result;
  for (const auto& quad : axis.quads)
  {
    result.push_back({ quad[0], quad[1], quad[2] });
    result.push_back({ quad[0], quad[2], quad[3] });
  }
  result.insert(result.end(), axis.triangles.begin(), axis.triangles.end());
  return result;
}

MedialAxis writtenAndRead(const MedialAxis& axis, const std::string& extension)
{
  const TemporaryFolder folder;
  writeAxis(axis, folder.file("axis" + extension));
  return readAxis(folder.file("axis" + extension));
}

TEST(AxisIo, PlyAndObjComeBackWhole)
{
  const MedialAxis axis = sample();
  for (const char* extension : { ".ply", ".obj" })
  {
    const MedialAxis read = writtenAndRead(axis, extension);
    EXPECT_EQ(read.points, axis.points) << extension;
    EXPECT_EQ(read.radius, axis.radius) << extension;
    EXPECT_EQ(read.quads, axis.quads) << extension;
    EXPECT_EQ(read.triangles, axis.triangles) << extension;
    EXPECT_EQ(read.lines, axis.lines) << extension;
    EXPECT_EQ(read.vertices, axis.vertices) << extension;
  }
}

TEST(AxisIo, MaComesBackWithQuadsAsTriangles)
{
  const MedialAxis axis = sample();
  const MedialAxis read = writtenAndRead(axis, ".ma");
  EXPECT_EQ(read.points, axis.points);
  EXPECT_EQ(read.radius, axis.radius);
  EXPECT_EQ(read.quads.size(), 0U);
  EXPECT_EQ(read.triangles, triangulated(axis));
  EXPECT_EQ(read.lines, axis.lines);
  EXPECT_EQ(read.vertices, axis.vertices);
}

TEST(AxisIo, EveryKindOfCellComesBackAlone)
{
  const MedialAxis axis = sample();
  for (const std::string extension : kExtensions)
  {
    for (int kind = 0; kind < 3; ++kind)
    {
      MedialAxis part;
      part.points = axis.points;
      part.radius = axis.radius;
      part.separationAngle = axis.separationAngle;
      part.lambda = axis.lambda;
      part.quads = kind == 0 ? axis.quads : decltype(axis.quads){};
      part.triangles = kind == 0 ? axis.triangles : Triangles{};
      part.lines = kind == 1 ? axis.lines : Lines{};
      part.vertices = kind == 2 ? axis.vertices : Ids{};
      const MedialAxis read = writtenAndRead(part, extension);
      EXPECT_EQ(triangulated(read), triangulated(part)) << extension;
      EXPECT_EQ(read.lines, part.lines) << extension;
    }
  }
}

TEST(AxisIo, PlyKeepsTheAngles)
{
  const MedialAxis axis = sample();
  const MedialAxis read = writtenAndRead(axis, ".ply");
  EXPECT_EQ(read.separationAngle, axis.separationAngle);
  EXPECT_EQ(read.lambda, axis.lambda);
  EXPECT_TRUE(writtenAndRead(axis, ".obj").lambda.empty());
}

TEST(AxisIo, StreamsGetTheBytesOfFiles)
{
  const TemporaryFolder folder;
  const MedialAxis axis = sample();
  for (const std::string extension : kExtensions)
  {
    const auto format = axisFormatOf("a" + extension);
    ASSERT_TRUE(format);
    std::ostringstream stream;
    writeAxis(axis, *format, stream);
    writeAxis(axis, folder.file("a" + extension));
    EXPECT_EQ(stream.str(), readFile(folder.file("a" + extension))) << extension;
  }
}

TEST(AxisIo, WritesTheDocumentedText)
{
  MedialAxis axis;
  axis.points = { { 0.0, 0.1, 1e-30 }, { 1.0, 0.0, 0.0 }, { 1.0, 1.0, 0.0 }, { 2.0, 0.0, 0.0 } };
  axis.radius = { 0.1F, 1.0F, 1.5F, 2.0F };
  axis.separationAngle = axis.lambda = { 1.0F, 2.0F, 3.0F, 4.0F };
  axis.triangles = { { 0, 1, 2 } };
  axis.lines = { { 3, 1 } };
  axis.vertices = { 3 };
  std::ostringstream obj;
  writeAxis(axis, AxisFormat::Obj, obj);
  EXPECT_EQ(obj.str(),
    "# medial axis: after each vertex the radius of its ball\n"
    "v 0 0.1 1e-30\n# radius 0.1\nv 1 0 0\n# radius 1\nv 1 1 0\n# radius 1.5\nv 2 0 0\n"
    "# radius 2\nf 1 2 3\nl 4 2\np 4\n");
  std::ostringstream ma;
  writeAxis(axis, AxisFormat::Ma, ma);
  EXPECT_EQ(ma.str(),
    "4 4 1\nv 0 0.1 1e-30 0.1\nv 1 0 0 1\nv 1 1 0 1.5\nv 2 0 0 2\ne 0 1\ne 0 2\ne 1 2\ne 1 3\n"
    "f 0 1 2\n");
}

std::string writeError(const std::string& path)
{
  return messageOf([&] { writeAxis(sample(), path); }, ErrorCode::CannotWrite);
}

TEST(AxisIo, NamesFilesThatCannotBeWritten)
{
  EXPECT_EQ(writeError("missing/a.ply"),
    "missing/a.ply: cannot be written: No such file or directory");
  EXPECT_EQ(writeError("a.vtp"),
    "a.vtp: cannot be written: unknown extension '.vtp', allowed: .ply .obj .ma");
  if (std::filesystem::exists("/dev/full"))
  {
    const TemporaryFolder folder;
    std::filesystem::create_symlink("/dev/full", folder.file("a.ma"));
    EXPECT_NE(writeError(folder.file("a.ma")).find("No space left on device"), std::string::npos);
  }
}

MedialAxis readText(const std::string& name, const std::string& content)
{
  const TemporaryFolder folder;
  writeFile(folder.file(name), content);
  return readAxis(folder.file(name));
}

TEST(AxisIo, ReadsWhatOthersWrite)
{
  // Trailing words, comments, blank lines and capitals.
  const MedialAxis ma = readText("a.MA",
    "4 4 1\n# made by hand\nv 0 0 0 1.5 0 1\nv 1 0 0 .5\n\nv 0 1 0 1e-3\nv 0 0 1 0\n"
    "e 1 0\ne 0 2\ne 1 2\ne 2 3 7\nf 0 1 2 9\n");
  EXPECT_EQ(ma.points.size(), 4U);
  EXPECT_EQ(ma.triangles, (Triangles{ { 0, 1, 2 } }));
  EXPECT_EQ(ma.lines, (Lines{ { 2, 3 } }));
  EXPECT_EQ(ma.radius[0], 1.5F);
  const MedialAxis ply = readText("a.ply",
    "ply\nformat ascii 1.0\nelement vertex 2\nproperty float x\nproperty float y\n"
    "property float z\nproperty double radius\nend_header\n0 0 0 2\n1 0 0 3\n");
  EXPECT_EQ(ply.vertices, (Ids{ 0, 1 }));
  EXPECT_EQ(ply.radius[1], 3.0F);
}

TEST(AxisIo, LargePolygonsAndPolylinesComeApart)
{
  std::string content;
  for (int i = 0; i < 5; ++i)
  {
    content += "v " + std::to_string(i) + " " + std::to_string(i * i) + " 0\n# radius 1\n";
  }
  const MedialAxis axis = readText("a.obj", content + "f 1 2 3 4 5\nl 1 2 3\np 4 5\n");
  EXPECT_EQ(axis.triangles, (Triangles{ { 0, 1, 2 }, { 0, 2, 3 }, { 0, 3, 4 } }));
  EXPECT_EQ(axis.lines, (Lines{ { 0, 1 }, { 1, 2 } }));
  EXPECT_EQ(axis.vertices, (Ids{ 3, 4 }));
}

// The message for a file that must be refused, without the folder's name.
std::string refusal(const std::string& name, const std::string& content,
  ErrorCode expected = ErrorCode::InvalidInput)
{
  return refusalOf<Error>(
    name, content, [](const std::string& file) { readAxis(file); },
    [&](const Error& error) { EXPECT_EQ(error.code(), expected); });
}

TEST(AxisIo, RefusesDamagedMa)
{
  const std::string header = "2 1 0\n";
  const std::string first = "v 0 0 0 1\n";
  EXPECT_EQ(refusal("a.ma", header + first + "v 0 1 0 -2\ne 0 1\n"),
    "a.ma: line 3: radius '-2' is outside [0, infinity)");
  EXPECT_EQ(refusal("a.ma", header + first + "v 0 1 0 nan\ne 0 1\n"),
    "a.ma: line 3: radius 'nan' is outside [0, infinity)");
  EXPECT_EQ(refusal("a.ma", header + first + "v 0 inf 0 1\ne 0 1\n"),
    "a.ma: line 3: 'inf' is not a finite coordinate");
  EXPECT_EQ(refusal("a.ma", header + first + "v 0 1 0\ne 0 1\n"),
    "a.ma: line 3: radius '' is outside [0, infinity)");
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

TEST(AxisIo, RefusesDamagedObj)
{
  const std::string first = "v 0 0 0\n# radius 1\n";
  EXPECT_EQ(refusal("a.obj", first + "v 0 1 0\nv 0 0 1\n# radius 2\n"),
    "a.obj: line 3: a vertex without radius; a line '# radius R' must follow it");
  EXPECT_EQ(refusal("a.obj", first + "v 0 1 0\n"),
    "a.obj: line 3: a vertex without radius; a line '# radius R' must follow it");
  EXPECT_EQ(refusal("a.obj", first + "v 0 1 0\n# radius -1\n"),
    "a.obj: line 4: radius '-1' is outside [0, infinity)");
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

TEST(AxisIo, RefusesDamagedPly)
{
  EXPECT_EQ(refusal("a.ply", plyOf("0 1 0 -3\n0 1\n")),
    "a.ply: point 1: radius -3 is outside [0, 1e+100]");
  EXPECT_EQ(refusal("a.ply", plyOf("0 nan 0 3\n0 1\n")),
    "a.ply: point 1: coordinate nan is outside [-1e+100, 1e+100]");
  EXPECT_EQ(refusal("a.ply", plyOf("0 1 0 1\n0 5\n")), "a.ply: point index 5 is outside [0, 1]");
  EXPECT_NE(refusal("a.ply", plyOf("0 1 0")).find("ends early or is damaged"), std::string::npos);
  EXPECT_EQ(refusal("a.ply",
              "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\n"
              "property float z\nend_header\n0 0 0\n"),
    "a.ply: its vertices have no property 'radius'");
}

TEST(AxisIo, RefusesFilesThatAreNone)
{
  EXPECT_EQ(refusal("a.vtp", "", ErrorCode::CannotRead),
    "a.vtp: unknown extension '.vtp', allowed: .ply .obj .ma");
  EXPECT_NE(refusal("a.ma", "").find("'' is not a count"), std::string::npos);
  EXPECT_THROW(readAxis("missing.ma"), Error);
}

// A file cut anywhere is refused or, if the cut leaves it complete, read as it is.
TEST(AxisIo, SurvivesEveryTruncation)
{
  const TemporaryFolder folder;
  const MedialAxis axis = sample();
  for (const std::string extension : kExtensions)
  {
    const std::string name = "axis" + extension;
    writeAxis(axis, folder.file(name));
    const std::string whole = readFile(folder.file(name));
    int refused = 0;
    for (std::size_t size = 0; size < whole.size(); size += 3)
    {
      writeFile(folder.file(name), whole.substr(0, size));
      try
      {
        EXPECT_LE(readAxis(folder.file(name)).points.size(), axis.points.size());
      }
      catch (const Error&)
      {
        ++refused;
      }
    }
    EXPECT_GT(refused, 50) << extension;
  }
}

} // namespace
} // namespace medial::test
