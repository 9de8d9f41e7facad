// The files that medial-axis writes.
#include "command_output.h"

#include "support/models.h"

#include <vtkDataArray.h>
#include <vtkOBJReader.h>
#include <vtkPLYReader.h>
#include <vtkPointData.h>
#include <vtkXMLImageDataReader.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <set>
#include <sstream>
#include <thread>

#include <sys/stat.h>

namespace medial::test
{
namespace
{

TEST_F(CommandOutput, VtpIsTheAxisOfTheBox)
{
  const auto medial = axis({});
  ASSERT_GT(medial->GetNumberOfPoints(), 100);
  ASSERT_GT(medial->GetNumberOfPolys(), 100);
  for (const char* name :
    { "Radius", "SeparationAngle", "Lambda", "ClosestPointA", "ClosestPointB" })
  {
    EXPECT_NE(medial->GetPointData()->GetArray(name), nullptr) << name;
  }
  for (vtkIdType i = 0; i < medial->GetNumberOfPoints(); ++i)
  {
    ASSERT_NEAR(radiusAt(medial, i), exactRadius(medial->GetPoint(i)), 1e-5);
  }
  EXPECT_NEAR(medial->GetPointData()->GetArray("Radius")->GetRange()[1], kHalfSides[2], 1e-3);
}

TEST_F(CommandOutput, PlyHoldsPointsRadiiAndFaces)
{
  const auto expected = axis({});
  run({ "-o", folder.file("axis.ply") });
  const auto read = readWith<vtkPLYReader>(folder.file("axis.ply"));
  EXPECT_EQ(read->GetNumberOfPoints(), expected->GetNumberOfPoints());
  EXPECT_EQ(read->GetNumberOfPolys(), expected->GetNumberOfPolys());

  const std::string bytes = readFile(folder.file("axis.ply"));
  const char* record = bytes.data() + bytes.find("end_header\n") + 11;
  for (vtkIdType i = 0; i < expected->GetNumberOfPoints(); ++i)
  {
    double point[3];
    float attributes[3];
    std::memcpy(point, record, sizeof(point));
    std::memcpy(attributes, record + sizeof(point), sizeof(attributes));
    record += sizeof(point) + sizeof(attributes);
    ASSERT_EQ(point[1], expected->GetPoint(i)[1]);
    ASSERT_EQ(static_cast<double>(attributes[0]), radiusAt(expected, i));
  }
}

TEST_F(CommandOutput, ObjHoldsPointsAndCells)
{
  const auto expected = axis({});
  run({ "-o", folder.file("axis.obj") });
  const auto read = readWith<vtkOBJReader>(folder.file("axis.obj"));
  EXPECT_EQ(read->GetNumberOfPoints(), expected->GetNumberOfPoints());
  EXPECT_EQ(read->GetNumberOfPolys(), expected->GetNumberOfPolys());
  EXPECT_EQ(read->GetNumberOfLines(), expected->GetNumberOfLines());
  EXPECT_NEAR(read->GetPoint(7)[0], expected->GetPoint(7)[0], 1e-6);
}

TEST_F(CommandOutput, MaHoldsSpheresEdgesAndTriangles)
{
  const auto expected = axis({});
  run({ "-o", folder.file("axis.ma") });
  std::istringstream text(readFile(folder.file("axis.ma")));
  vtkIdType vertices = 0;
  vtkIdType edges = 0;
  vtkIdType faces = 0;
  text >> vertices >> edges >> faces;
  ASSERT_EQ(vertices, expected->GetNumberOfPoints());
  ASSERT_GE(faces, expected->GetNumberOfPolys());
  std::string kind;
  for (vtkIdType i = 0; i < vertices; ++i)
  {
    double x = 0.0;
    double y = 0.0;
    double z = 0.0;
    double r = 0.0;
    text >> kind >> x >> y >> z >> r;
    ASSERT_EQ(kind, "v");
    ASSERT_EQ(z, expected->GetPoint(i)[2]);
    ASSERT_NEAR(r, radiusAt(expected, i), 1e-7);
  }
  std::set<std::pair<vtkIdType, vtkIdType>> sides;
  for (vtkIdType i = 0; i < edges; ++i)
  {
    vtkIdType a = 0;
    vtkIdType b = 0;
    text >> kind >> a >> b;
    ASSERT_EQ(kind, "e");
    ASSERT_TRUE(a < b && b < vertices);
    sides.emplace(a, b);
  }
  EXPECT_EQ(static_cast<vtkIdType>(sides.size()), edges);
  for (vtkIdType i = 0; i < faces; ++i)
  {
    vtkIdType a = 0;
    vtkIdType b = 0;
    vtkIdType c = 0;
    text >> kind >> a >> b >> c;
    ASSERT_EQ(kind, "f");
    ASSERT_EQ(sides.count(std::minmax(a, b)), 1U);
    ASSERT_EQ(sides.count(std::minmax(b, c)), 1U);
  }
  EXPECT_FALSE(text >> kind);
}

TEST_F(CommandOutput, FieldHasAllArraysAndTheRightDistance)
{
  run({ "--field", folder.file("field.vti") });
  const auto field = readWith<vtkXMLImageDataReader>(folder.file("field.vti"));
  EXPECT_EQ(field->GetDimensions()[0], kResolution);
  for (const char* name :
    { "Distance", "ClosestPoint", "ClosestCell", "ClosestFeature", "ClosestSite" })
  {
    EXPECT_NE(field->GetPointData()->GetArray(name), nullptr) << name;
  }
  double centre[3] = { 0.0, 0.0, 0.0 };
  const vtkIdType nearest = field->FindPoint(centre);
  EXPECT_NEAR(field->GetPointData()->GetArray("Distance")->GetTuple1(nearest),
    -exactRadius(field->GetPoint(nearest)), 1e-5);
}

// Every triangle of an STL file has corners of its own. Points that no cell uses do not show
// either.
TEST_F(CommandOutput, PictureOfAnUnweldedMeshIsThatOfTheWeldedOne)
{
  const TriangleMesh sphere = icosphere(1.0, 3);
  writeFile(folder.file("sphere.obj"), objText(sphere));
  writeFile(folder.file("sphere.stl"), stlText(sphere));
  writeFile(folder.file("lone.obj"), objText(sphere) + "v 1000 500 0\n");
  std::vector<vtkSmartPointer<vtkImageData>> pictures;
  for (const char* name : { "sphere.obj", "sphere.stl", "lone.obj" })
  {
    input = folder.file(name);
    run({ "--image", folder.file("picture.png") });
    pictures.push_back(readPng(folder.file("picture.png")));
  }
  int different = 0;
  for (int y = 0; y < 1050; y += 2) // below the names of the files
  {
    for (int x = 0; x < 1200; x += 2) // left of the scalar bar
    {
      for (const int other : { 1, 2 })
      {
        different += std::abs(pictures[0]->GetScalarComponentAsDouble(x, y, 0, 0) -
                       pictures[other]->GetScalarComponentAsDouble(x, y, 0, 0)) > 16.0
          ? 1
          : 0;
      }
    }
  }
  EXPECT_LT(different, 315); // of 315,000
}

TEST_F(CommandOutput, PictureShowsTheAxisInColourOnWhite)
{
  run({ "--image", folder.file("picture.png") });
  const auto picture = readPng(folder.file("picture.png"));
  ASSERT_EQ(picture->GetDimensions()[0], 1600);
  ASSERT_EQ(picture->GetDimensions()[1], 1200);
  int coloured = 0;
  int white = 0;
  for (int y = 0; y < 1200; y += 4)
  {
    for (int x = 0; x < 1200; x += 4) // left of the scalar bar
    {
      double low = 255.0;
      double high = 0.0;
      for (int channel = 0; channel < 3; ++channel)
      {
        const double value = picture->GetScalarComponentAsDouble(x, y, 0, channel);
        low = std::min(low, value);
        high = std::max(high, value);
      }
      coloured += high - low > 40.0 ? 1 : 0;
      white += low == 255.0 ? 1 : 0;
    }
  }
  EXPECT_GT(coloured, 9000); // of 90,000
  EXPECT_GT(white, 9000);
}

TEST_F(CommandOutput, WithoutOutputOptionsTheAxisGoesToTheCurrentFolder)
{
  RunOptions options;
  options.folder = folder.path();
  const Outcome outcome = runMedialAxis({ "box.obj", "--resolution", "16" }, options);
  EXPECT_EQ(outcome.exitCode, 0) << outcome.err;
  EXPECT_EQ(folder.list(), (std::vector<std::string>{ "box.obj", "box_medial.vtp" }));
  EXPECT_TRUE(contains(outcome.out, "box_medial.vtp: medial axis"));
}

TEST_F(CommandOutput, TwoProcessesComputeOnTheDeviceAtOnce)
{
  const auto compute = [this](const std::string& name)
  {
    const Outcome outcome = run({ "--engine", "device", "--threads", "8", "-o",
      folder.file(name + ".vtp"), "--field", folder.file(name + ".vti") });
    EXPECT_TRUE(contains(outcome.out, "engine    device on ")) << outcome.out;
    EXPECT_EQ(outcome.err, "");
  };
  compute("alone");
  std::thread other([&] { compute("first"); });
  compute("second");
  other.join();
  for (const std::string type : { ".vtp", ".vti" })
  {
    const std::string expected = readFile(folder.file("alone" + type));
    EXPECT_GT(expected.size(), 1000U);
    EXPECT_TRUE(readFile(folder.file("first" + type)) == expected);
    EXPECT_TRUE(readFile(folder.file("second" + type)) == expected);
  }
}

TEST_F(CommandOutput, ReplacesFilesWithTheirModeAndThroughLinks)
{
  const std::string target = folder.file("target.ma");
  const std::string link = folder.file("link.ma");
  writeFile(target, "old");
  chmod(target.c_str(), 0640);
  std::filesystem::create_symlink("target.ma", link);
  run({ "-o", link });
  EXPECT_TRUE(std::filesystem::is_symlink(link));
  EXPECT_NE(readFile(target), "old");
  struct stat status = {};
  ASSERT_EQ(stat(target.c_str(), &status), 0);
  EXPECT_EQ(status.st_mode & 0777U, 0640U);
}

TEST_F(CommandOutput, WritesEverythingAtOnceForARealMesh)
{
  const auto model = modelPath("paper/triceratops.off");
  const std::string mesh = model ? *model : input;
  const Outcome outcome =
    runMedialAxis({ mesh, "--resolution", "64", "-o", folder.file("a.ply"), "--field",
      folder.file("a.vti"), "--image", folder.file("a.png"), "--report", folder.file("a.json") });
  EXPECT_EQ(outcome.exitCode, 0) << outcome.err;
  EXPECT_EQ(folder.list(),
    (std::vector<std::string>{ "a.json", "a.ply", "a.png", "a.vti", "box.obj" }));
  EXPECT_GT(Json::parse(readFile(folder.file("a.json")))["counts"]["medial_cells"], 100);
}

} // namespace
} // namespace medial::test
