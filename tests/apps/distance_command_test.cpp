// medial-distance as a user runs it.
#include "command_run.h"
#include "scan_files.h"

#include "support/shapes.h"
#include "support/transforms.h"

#include <vtkDoubleArray.h>
#include <vtkImageData.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkXMLPolyDataReader.h>

#include <cmath>
#include <sstream>
#include <string>
#include <vector>

namespace medial::test
{
namespace
{

class DistanceCommand : public ::testing::Test
{
protected:
  DistanceCommand()
  {
    writeFile(mesh, objText(box({ 2.0, 1.0, 0.5 })));
    writeFile(points, "x,y,z\n0.25,0.5,2.5\n0.25,0.5,0\n0,4,4.5\n");
  }

  Json json(const std::string& onMesh, const std::string& of,
    std::vector<std::string> arguments = {}) const
  {
    arguments.insert(arguments.begin(), { onMesh, of, "--json", "-" });
    const Outcome outcome = runMedialDistance(arguments);
    EXPECT_EQ(outcome.exitCode, 0) << outcome.err;
    EXPECT_EQ(outcome.err, "");
    return Json::parse(outcome.out);
  }

  /// A run that must fail with one line and without a file.
  static std::string failure(int exitCode, std::vector<std::string> arguments,
    const RunOptions& options = {})
  {
    const TemporaryFolder outputs;
    arguments.insert(arguments.end(),
      { "--json", outputs.file("result.json"), "-o", outputs.file("result.vtp") });
    const Outcome outcome = runMedialDistance(arguments, options);
    EXPECT_EQ(outcome.exitCode, exitCode) << outcome.err;
    EXPECT_EQ(outcome.out, "");
    EXPECT_EQ(outcome.err.rfind("medial-distance: ", 0), 0U) << outcome.err;
    EXPECT_EQ(outcome.err.find('\n'), outcome.err.size() - 1) << outcome.err;
    EXPECT_EQ(outputs.list(), std::vector<std::string>());
    return outcome.err;
  }

  TemporaryFolder folder;
  std::string mesh = folder.file("box.obj");
  std::string points = folder.file("points.csv");
};

// The surface of a ball of labels, 4 around the centre of the image.
TEST_F(DistanceCommand, TakesTheSurfaceOfAScan)
{
  const std::string scan = folder.file("ball.nrrd");
  writeFile(scan, nrrdFile(LabelImage([](double r) { return r < 4.0 ? 2 : 0; }), "raw"));
  writeFile(points, "x,y,z\n10,-20,30\n10,-20,36\n");
  const Json result = json(scan, points, { "--label", "2" });
  EXPECT_EQ(result["distance"]["inside"], 1);
  EXPECT_NEAR(result["distance"]["min"], -4.0, 0.3);
  EXPECT_NEAR(result["distance"]["max"], 2.0, 0.3);

  EXPECT_TRUE(contains(failure(2, { scan, points }),
    "ball.nrrd is an image: choose its surface with --isovalue V or --label N"));
  EXPECT_TRUE(contains(failure(3, { scan, points, "--label", "5" }), "those that occur: 0, 2"));
  EXPECT_TRUE(contains(failure(2, { mesh, points, "--label", "2" }), "--label needs an image"));
}

TEST_F(DistanceCommand, SummarisesPoints)
{
  const Json result = json(mesh, points);
  EXPECT_EQ(result["mesh"]["triangles"], 12);
  EXPECT_EQ(result["points"]["count"], 3);
  EXPECT_EQ(result["sign"]["method"], "winding");
  EXPECT_EQ(result["distance"]["inside"], 1);
  EXPECT_NEAR(result["distance"]["min"], -0.5, 1e-12);
  EXPECT_NEAR(result["distance"]["max"], 5.0, 1e-12);
  EXPECT_NEAR(result["distance"]["mean"], 2.5, 1e-12);
  EXPECT_NEAR(result["distance"]["rms"], std::sqrt(29.25 / 3.0), 1e-12);
  EXPECT_NEAR(result["distance"]["median"], 2.0, 1e-12);
  EXPECT_NEAR(result["distance"]["percentile_95"], 5.0, 1e-12);
  EXPECT_TRUE(result["hausdorff"].is_null());
  EXPECT_TRUE(json(mesh, points, { "--sign", "none" })["distance"]["inside"].is_null());
}

TEST_F(DistanceCommand, WritesALineForEachPoint)
{
  const std::string output = folder.file("distances.csv");
  const Outcome outcome = runMedialDistance({ mesh, points, "-q", "-o", output });
  EXPECT_EQ(outcome.exitCode, 0) << outcome.err;
  EXPECT_EQ(outcome.out, "");
  std::istringstream lines(readFile(output));
  std::string line;
  std::getline(lines, line);
  EXPECT_EQ(line.substr(0, 15), "x,y,z,distance,");
  std::getline(lines, line);
  EXPECT_EQ(line.substr(0, 28), "0.25,0.5,2.5,2,0.25,0.5,0.5,");
  std::getline(lines, line);
  EXPECT_EQ(line.substr(0, 16), "0.25,0.5,0,-0.5,");
}

TEST_F(DistanceCommand, WritesPointsWithArrays)
{
  const std::string output = folder.file("distances.vtp");
  ASSERT_EQ(runMedialDistance({ mesh, points, "-o", output }).exitCode, 0);
  vtkNew<vtkXMLPolyDataReader> reader;
  reader->SetFileName(output.c_str());
  reader->Update();
  vtkPolyData* data = reader->GetOutput();
  EXPECT_EQ(data->GetNumberOfVerts(), 3);
  EXPECT_NEAR(data->GetPointData()->GetArray("Distance")->GetTuple1(2), 5.0, 1e-12);
  for (const char* name : { "ClosestPoint", "ClosestCell", "ClosestFeature", "Direction" })
  {
    EXPECT_NE(data->GetPointData()->GetArray(name), nullptr) << name;
  }
}

struct Colour
{
  double red;
  double green;
  double blue;
};

/// Counts the pixels left of the scalar bar whose colour is as wanted.
template <typename F>
int countPixels(vtkImageData* picture, const F& isWanted)
{
  int count = 0;
  for (int y = 0; y < 1100; ++y) // below the caption
  {
    for (int x = 0; x < 1300; ++x)
    {
      const auto channel = [&](int c) { return picture->GetScalarComponentAsDouble(x, y, 0, c); };
      count += isWanted(Colour{ channel(0), channel(1), channel(2) }) ? 1 : 0;
    }
  }
  return count;
}

/// Whether a colour is one of the yellow end of the scale of magnitudes.
bool isHigh(const Colour& c)
{
  return c.red > 150.0 && c.green > 140.0 && c.blue < 90.0;
}

/// Whether a colour is one of the dark blue end of the scale of magnitudes.
bool isLow(const Colour& c)
{
  return c.blue > c.green + 25.0 && c.red < 110.0 && c.green < 60.0;
}

/// Whether a colour is red, as outside.
bool isOutside(const Colour& c)
{
  return c.red - c.blue > 80.0;
}

/// Whether a colour is blue, as inside.
bool isInside(const Colour& c)
{
  return c.red - c.blue < -40.0;
}

TEST_F(DistanceCommand, DrawsDeviationsFromNoneToTheLargest)
{
  const std::string other = folder.file("stretched.obj");
  const std::string image = folder.file("deviation.png");
  // Its right end is 1 away from the mesh, the left one in the same place.
  TriangleMesh stretched = box({ 2.0, 1.0, 0.5 });
  for (Point3& p : stretched.points)
  {
    p[0] += p[0] > 0.0 ? 1.0 : 0.0;
  }
  writeFile(other, objText(stretched));
  const Outcome outcome = runMedialDistance({ mesh, other, "-q", "--image", image });
  EXPECT_EQ(outcome.exitCode, 0) << outcome.err;
  const auto picture = readPng(image);
  EXPECT_EQ(picture->GetDimensions()[0], 1600);
  EXPECT_EQ(picture->GetDimensions()[1], 1200);
  EXPECT_GT(countPixels(picture, isHigh), 1000);
  EXPECT_GT(countPixels(picture, isLow), 1000);
}

// One end of a box lies outside of the mesh, the other one inside.
TEST_F(DistanceCommand, DrawsInsideAndOutsideInTwoColours)
{
  TriangleMesh moved = box({ 2.0, 1.0, 0.5 });
  for (Point3& p : moved.points)
  {
    p = { 0.9 * p[0] + 0.5, 0.9 * p[1], 0.9 * p[2] };
  }
  const std::string other = folder.file("moved.obj");
  const std::string image = folder.file("deviation.png");
  writeFile(other, objText(moved));
  const Outcome outcome = runMedialDistance({ mesh, other, "-q", "--image", image });
  EXPECT_EQ(outcome.exitCode, 0) << outcome.err;
  const auto picture = readPng(image);
  EXPECT_GT(countPixels(picture, isOutside), 1000);
  EXPECT_GT(countPixels(picture, isInside), 1000);
}

TEST_F(DistanceCommand, DrawsPointsAroundTheMesh)
{
  const std::string image = folder.file("points.png");
  const Outcome outcome = runMedialDistance({ mesh, points, "-q", "--image", image });
  EXPECT_EQ(outcome.exitCode, 0) << outcome.err;
  EXPECT_GT(countPixels(readPng(image), isOutside), 10); // the farthest one
}

TEST_F(DistanceCommand, RefusesPicturesOfOtherFormats)
{
  EXPECT_NE(failure(2, { mesh, points, "--image", folder.file("picture.jpg") }).find("--image"),
    std::string::npos);
}

TEST_F(DistanceCommand, ComparesTwoMeshes)
{
  const std::string other = folder.file("other.obj");
  // A box that is 0.25 higher: its top and the sides beside it are off by that.
  writeFile(other, objText(translated(box({ 2.0, 1.0, 0.625 }), { 0.0, 0.0, 0.125 })));
  const std::string output = folder.file("deviation.vtp");
  const Json result = json(mesh, other, { "-o", output });
  EXPECT_NEAR(result["hausdorff"]["distance"], 0.25, 1e-9);
  EXPECT_NEAR(result["hausdorff"]["points_to_mesh"]["distance"], 0.25, 1e-9);
  EXPECT_NEAR(result["hausdorff"]["mesh_to_points"]["distance"], 0.25, 1e-9);
  EXPECT_NEAR(result["distance"]["mean"], 0.125, 1e-12);
  vtkNew<vtkXMLPolyDataReader> reader;
  reader->SetFileName(output.c_str());
  reader->Update();
  EXPECT_EQ(reader->GetOutput()->GetNumberOfPolys(), 12);
}

TEST_F(DistanceCommand, RefusesBadInput)
{
  const std::string bad = folder.file("bad.xyz");
  writeFile(bad, "0 0 0\n1 2 nan\n");
  EXPECT_TRUE(contains(failure(kBadInput, { mesh, bad }),
    "bad.xyz: line 2: 'nan' is not a finite coordinate"));
  writeFile(bad, "");
  EXPECT_NE(failure(kBadInput, { mesh, bad }).find("the file is empty"), std::string::npos);
  EXPECT_NE(failure(kBadInput, { mesh, folder.file("absent.ply") }).find("no such file"),
    std::string::npos);
  EXPECT_NE(failure(kBadInput, { points, points }).find("unknown extension '.csv'"),
    std::string::npos);
  const std::string open = folder.file("open.obj");
  writeFile(open, objText(plates(1.0, 1.0)));
  EXPECT_NE(failure(kBadInput, { open, points, "--sign", "pseudonormal" }).find("open.obj: sign"),
    std::string::npos);
}

TEST_F(DistanceCommand, RefusesWrongUse)
{
  EXPECT_NE(failure(kUsage, { mesh }).find("POINTS"), std::string::npos);
  EXPECT_NE(failure(kUsage, { mesh, points, "--sign", "maybe" }).find("maybe"), std::string::npos);
  const Outcome outcome = runMedialDistance({ mesh, points, "-o", folder.file("a.stl") });
  EXPECT_EQ(outcome.exitCode, kUsage);
  EXPECT_EQ(runMedialDistance({ mesh, points, "-o", points }).exitCode, kUsage);
  EXPECT_EQ(readFile(points).substr(0, 5), "x,y,z");
}

TEST_F(DistanceCommand, LeavesNothingWhereTheDiskIsFull)
{
  RunOptions options;
  options.fileSizeLimit = 100;
  failure(kNoSpace, { mesh, points }, options);
}

} // namespace
} // namespace medial::test
