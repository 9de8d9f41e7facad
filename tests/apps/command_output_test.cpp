#include "mesh_texts.h"
#include "program.h"

#include "support/models.h"
#include "support/shapes.h"

#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkOBJReader.h>
#include <vtkPLYReader.h>
#include <vtkPNGReader.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkXMLImageDataReader.h>
#include <vtkXMLPolyDataReader.h>

#include <nlohmann/json.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <set>
#include <sstream>

#include <sys/stat.h>

namespace medial::test
{
namespace
{

using Json = nlohmann::json;

constexpr Point3 kHalfSides{ 1.0, 0.7, 0.4 };
constexpr int kResolution = 41;
constexpr double kSpacing = 0.056; // of the grid, rounded up

class CommandOutput : public ::testing::Test
{
protected:
  CommandOutput() { writeFile(input, objText(box(kHalfSides))); }

  // Runs on the box, which must succeed.
  Outcome run(std::vector<std::string> arguments)
  {
    arguments.insert(arguments.begin(), input);
    if (std::find(arguments.begin(), arguments.end(), "--spacing") == arguments.end())
    {
      arguments.insert(arguments.end(), { "--resolution", std::to_string(kResolution) });
    }
    Outcome outcome = runMedialAxis(arguments);
    EXPECT_EQ(outcome.exitCode, 0) << outcome.err;
    return outcome;
  }

  vtkSmartPointer<vtkPolyData> axis(std::vector<std::string> arguments)
  {
    arguments.insert(arguments.end(), { "-o", folder.file("axis.vtp") });
    run(arguments);
    return readVtp(folder.file("axis.vtp"));
  }

  Json report(std::vector<std::string> arguments)
  {
    arguments.insert(arguments.end(), { "--report", folder.file("report.json") });
    run(arguments);
    return Json::parse(readFile(folder.file("report.json")));
  }

  static vtkSmartPointer<vtkPolyData> readVtp(const std::string& path)
  {
    vtkNew<vtkXMLPolyDataReader> reader;
    reader->SetFileName(path.c_str());
    reader->Update();
    return reader->GetOutput();
  }

  TemporaryFolder folder;
  std::string input = folder.file("box.obj");
};

bool contains(const std::string& text, const std::string& part)
{
  return text.find(part) != std::string::npos;
}

double radiusAt(vtkPolyData* axis, vtkIdType point)
{
  return axis->GetPointData()->GetArray("Radius")->GetTuple1(point);
}

// Distance from a point inside the box to its surface.
double exactRadius(const double* point)
{
  return std::min({ kHalfSides[0] - std::abs(point[0]), kHalfSides[1] - std::abs(point[1]),
    kHalfSides[2] - std::abs(point[2]) });
}

std::set<std::string> keysOf(const Json& object)
{
  std::set<std::string> keys;
  for (const auto& item : object.items())
  {
    keys.insert(item.key());
  }
  return keys;
}

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
  vtkNew<vtkPLYReader> reader;
  reader->SetFileName(folder.file("axis.ply").c_str());
  reader->Update();
  EXPECT_EQ(reader->GetOutput()->GetNumberOfPoints(), expected->GetNumberOfPoints());
  EXPECT_EQ(reader->GetOutput()->GetNumberOfPolys(), expected->GetNumberOfPolys());

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
  vtkNew<vtkOBJReader> reader;
  reader->SetFileName(folder.file("axis.obj").c_str());
  reader->Update();
  vtkPolyData* read = reader->GetOutput();
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
  vtkNew<vtkXMLImageDataReader> reader;
  reader->SetFileName(folder.file("field.vti").c_str());
  reader->Update();
  vtkImageData* field = reader->GetOutput();
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

// Every triangle of an STL file has corners of its own.
TEST_F(CommandOutput, PictureOfAnUnweldedMeshIsThatOfTheWeldedOne)
{
  const TriangleMesh sphere = icosphere(1.0, 3);
  writeFile(folder.file("sphere.obj"), objText(sphere));
  writeFile(folder.file("sphere.stl"), stlText(sphere));
  std::vector<vtkSmartPointer<vtkImageData>> pictures;
  for (const char* name : { "sphere.obj", "sphere.stl" })
  {
    input = folder.file(name);
    run({ "--image", folder.file("picture.png") });
    vtkNew<vtkPNGReader> reader;
    reader->SetFileName(folder.file("picture.png").c_str());
    reader->Update();
    pictures.emplace_back(reader->GetOutput());
  }
  int different = 0;
  for (int y = 0; y < 1200; y += 2)
  {
    for (int x = 0; x < 1200; x += 2) // left of the scalar bar
    {
      different += std::abs(pictures[0]->GetScalarComponentAsDouble(x, y, 0, 0) -
                     pictures[1]->GetScalarComponentAsDouble(x, y, 0, 0)) > 16.0
        ? 1
        : 0;
    }
  }
  EXPECT_LT(different, 360); // of 360,000
}

TEST_F(CommandOutput, PictureShowsTheAxisInColourOnWhite)
{
  run({ "--image", folder.file("picture.png") });
  vtkNew<vtkPNGReader> reader;
  reader->SetFileName(folder.file("picture.png").c_str());
  reader->Update();
  vtkImageData* picture = reader->GetOutput();
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

TEST_F(CommandOutput, ReportHasExactlyTheDocumentedKeys)
{
  const Json result = report({});
  EXPECT_EQ(keysOf(result),
    (std::set<std::string>{ "input", "grid", "device", "seconds", "counts", "fragments_per_voxel",
      "simplification", "evaluator", "sign_method", "topology", "coverage", "peak_memory_mib" }));
  EXPECT_EQ(keysOf(result["coverage"]),
    (std::set<std::string>{ "uncovered_share", "reach", "samples", "seconds" }));
  EXPECT_EQ(keysOf(result["simplification"]),
    (std::set<std::string>{ "input_points", "input_components", "components", "joined", "forced",
      "dropped", "seconds" }));
  EXPECT_EQ(keysOf(result["input"]),
    (std::set<std::string>{ "path", "triangles", "vertices", "closed", "manifold", "components",
      "skipped_degenerate" }));
  EXPECT_EQ(keysOf(result["grid"]), (std::set<std::string>{ "dimensions", "spacing", "origin" }));
  EXPECT_EQ(keysOf(result["device"]), (std::set<std::string>{ "renderer", "version", "software" }));
  EXPECT_EQ(keysOf(result["seconds"]),
    (std::set<std::string>{ "read", "sites", "cull", "polygons", "draw", "resolve", "medial",
      "write", "total" }));
  EXPECT_EQ(keysOf(result["counts"]),
    (std::set<std::string>{ "sites", "polygons", "fragments", "candidate_pairs", "medial_points",
      "medial_cells" }));
}

TEST_F(CommandOutput, ReportsTheTopology)
{
  const std::set<std::string> keys{ "components", "euler_characteristic", "genus", "cavities" };
  writeFile(input, objText(torus(1.0, 0.3, 24, 12)));
  const Json selected = report({ "--angle", "150" })["topology"];
  EXPECT_EQ(keysOf(selected), (std::set<std::string>{ "mode", "solid", "axis" }));
  EXPECT_EQ(selected["mode"], "selected");
  EXPECT_TRUE(selected["solid"].is_null());
  EXPECT_EQ(keysOf(selected["axis"]), keys);
  EXPECT_GT(selected["axis"]["components"], 1);
  const Json preserved = report({ "--angle", "150", "--topology", "preserve" })["topology"];
  EXPECT_EQ(preserved["mode"], "preserve");
  EXPECT_EQ(keysOf(preserved["solid"]), keys);
  EXPECT_EQ(preserved["solid"], preserved["axis"]);
  EXPECT_EQ(preserved["axis"]["components"], 1);
  EXPECT_EQ(preserved["axis"]["euler_characteristic"], 0);
  EXPECT_EQ(preserved["axis"]["genus"], 1);
  EXPECT_EQ(preserved["axis"]["cavities"], 0);
}

TEST_F(CommandOutput, ReportIsPlausible)
{
  const Json result = report({ "-o", folder.file("axis.vtp") });
  EXPECT_EQ(result["input"]["path"], input);
  EXPECT_EQ(result["input"]["triangles"], 12);
  EXPECT_EQ(result["input"]["vertices"], 8);
  EXPECT_EQ(result["input"]["closed"], true);
  EXPECT_EQ(result["input"]["manifold"], true);
  EXPECT_EQ(result["input"]["components"], 1);
  EXPECT_EQ(result["input"]["skipped_degenerate"], 0);
  EXPECT_EQ(result["grid"]["dimensions"][0], kResolution);
  EXPECT_EQ(result["sign_method"], "pseudonormal");
  EXPECT_EQ(result["counts"]["sites"], 12 + 18 + 8);
  EXPECT_EQ(result["counts"]["medial_points"],
    readVtp(folder.file("axis.vtp"))->GetNumberOfPoints());
  EXPECT_NE(result["device"]["renderer"], "");
  EXPECT_GE(result["fragments_per_voxel"].get<double>(), 1.0);
  EXPECT_GT(result["peak_memory_mib"].get<double>(), 1.0);
  double sum = 0.0;
  for (const auto& item : result["seconds"].items())
  {
    EXPECT_GE(item.value().get<double>(), 0.0) << item.key();
    sum += item.key() == "total" ? 0.0 : item.value().get<double>();
  }
  EXPECT_LE(sum, result["seconds"]["total"].get<double>() * 1.01);
  EXPECT_GT(sum, 0.0);
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

TEST_F(CommandOutput, SaysWhatItDidUnlessQuiet)
{
  const std::string file = folder.file("axis.vtp");
  const Outcome loud = run({ "-o", file });
  for (const std::string& part : { input + ": 12 triangles, 8 vertices, 1 component, closed",
         std::string("renderer"), std::string("seconds"), file + ": medial axis" })
  {
    EXPECT_TRUE(contains(loud.out, part)) << loud.out;
  }
  EXPECT_EQ(loud.err, "");
  const Outcome quiet = run({ "-o", file, "--quiet" });
  EXPECT_EQ(quiet.out + quiet.err, "");
}

TEST_F(CommandOutput, SpacingAndPaddingMakeTheGrid)
{
  const Json grid = report({ "--spacing", "0.1", "--padding", "0.5" })["grid"];
  EXPECT_DOUBLE_EQ(grid["spacing"][1].get<double>(), 0.1);
  const double diagonal = 2.0 * std::sqrt(1.0 + 0.49 + 0.16);
  EXPECT_NEAR(grid["origin"][0].get<double>(), -1.0 - 0.5 * diagonal, 0.1);
}

TEST_F(CommandOutput, AngleDropsTheEdgeSheets)
{
  const auto whole = axis({ "--angle", "60" });
  const auto flat = axis({ "--angle", "120" });
  EXPECT_LT(flat->GetNumberOfPoints(), whole->GetNumberOfPoints() / 2);
  for (vtkIdType i = 0; i < flat->GetNumberOfPoints(); ++i)
  {
    ASSERT_NEAR(flat->GetPoint(i)[2], 0.0, 0.5 * kSpacing);
  }
}

TEST_F(CommandOutput, MaxSpheresMakesTheAxisCompact)
{
  const std::string ma = folder.file("axis.ma");
  const Json result = report({ "--max-spheres", "24", "-o", ma });
  EXPECT_EQ(readFile(ma).substr(0, 3), "24 ");
  EXPECT_EQ(result["counts"]["medial_points"], 24);
  const Json& simplification = result["simplification"];
  EXPECT_GT(simplification["input_points"], 1000);
  EXPECT_EQ(simplification["components"], 1);
  EXPECT_EQ(simplification["dropped"], 0);
  const auto compact = axis({ "--max-spheres", "24" });
  std::set<int> corners; // of the box, where the sheets end
  for (vtkIdType i = 0; i < compact->GetNumberOfPoints(); ++i)
  {
    const double* p = compact->GetPoint(i);
    const double radius = radiusAt(compact, i);
    ASSERT_NEAR(radius, exactRadius(p), 0.2 * kSpacing);
    const bool atCorner = std::abs(p[0]) > 0.9 && std::abs(p[1]) > 0.6 && std::abs(p[2]) > 0.3;
    corners.insert(atCorner ? (p[0] > 0.0) + 2 * (p[1] > 0.0) + 4 * (p[2] > 0.0) : -1);
  }
  corners.erase(-1);
  EXPECT_EQ(corners.size(), 8U);
}

TEST_F(CommandOutput, SaysWhichComponentsMaxSpheresLeavesOut)
{
  const TriangleMesh one = box(kHalfSides);
  writeFile(input, objText(appended(one, translated(scaled(one, 0.5), { 3.0, 0.0, 0.0 }))));
  const Outcome outcome = run({ "--max-spheres", "1", "-o", folder.file("axis.vtp") });
  EXPECT_TRUE(contains(outcome.err,
    "--max-spheres 1 is below the number of components of the axis, 2; the 1 smallest"))
    << outcome.err;
  const auto left = readVtp(folder.file("axis.vtp"));
  ASSERT_EQ(left->GetNumberOfPoints(), 1);
  EXPECT_LT(left->GetPoint(0)[0], 1.0);
  EXPECT_EQ(
    axis({ "--max-spheres", "1", "--side", "exterior", "--angle", "170" })->GetNumberOfPolys(), 0);
}

TEST_F(CommandOutput, RepresentationsDiffer)
{
  EXPECT_EQ(axis({ "--representation", "points" })->GetNumberOfPolys(), 0);
  const auto faces = axis({ "--representation", "faces" });
  ASSERT_GT(faces->GetNumberOfPolys(), 100);
  for (vtkIdType i = 0; i < faces->GetNumberOfPolys(); ++i)
  {
    double bounds[6];
    faces->GetCellBounds(i, bounds);
    const int flat = (bounds[1] == bounds[0]) + (bounds[3] == bounds[2]) + (bounds[5] == bounds[4]);
    ASSERT_EQ(flat, 1);
  }
}

TEST_F(CommandOutput, AConvexShapeHasNoExteriorAxis)
{
  const Outcome outcome = run({ "--side", "exterior", "-o", folder.file("axis.vtp") });
  EXPECT_EQ(readVtp(folder.file("axis.vtp"))->GetNumberOfPoints(), 0);
  EXPECT_TRUE(contains(outcome.err, "60 degrees or more")) << outcome.err;
  run({ "--side", "exterior", "--image", folder.file("picture.png") });
  run({ "--side", "exterior", "-o", folder.file("axis.ma") });
  EXPECT_EQ(readFile(folder.file("axis.ma")), "0 0 0\n");
}

TEST_F(CommandOutput, AnOpenMeshGivesBothSidesAndANote)
{
  writeFile(input, objText(plates(0.6, 1.0)));
  const Outcome outcome = run({ "-o", folder.file("axis.vtp"), "--report", folder.file("r.json") });
  EXPECT_TRUE(contains(outcome.err, "the mesh is not closed")) << outcome.err;
  EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1);
  EXPECT_GT(readVtp(folder.file("axis.vtp"))->GetNumberOfPolys(), 0);
  const Json result = Json::parse(readFile(folder.file("r.json")));
  EXPECT_EQ(result["sign_method"], "none");
  EXPECT_EQ(result["input"]["closed"], false);
  EXPECT_EQ(run({ "--side", "both", "-o", folder.file("axis.vtp") }).err, "");
}

TEST_F(CommandOutput, AMisorientedMeshGivesBothSidesAndANote)
{
  TriangleMesh mesh = box(kHalfSides);
  std::swap(mesh.triangles[4][0], mesh.triangles[4][1]);
  writeFile(input, objText(mesh));
  const Outcome outcome = run({ "-o", folder.file("axis.vtp") });
  EXPECT_TRUE(contains(outcome.err, "the mesh is not consistently oriented")) << outcome.err;
}

TEST_F(CommandOutput, SignNoneOnAClosedMeshGivesBothSides)
{
  const Outcome outcome = run({ "--sign", "none", "-o", folder.file("axis.vtp") });
  EXPECT_TRUE(contains(outcome.err, "sign method none")) << outcome.err;
}

TEST_F(CommandOutput, ThreadsAndMemoryDoNotChangeTheResult)
{
  const auto expected = axis({});
  const auto limited = axis({ "--threads", "1", "--memory", "64" });
  ASSERT_EQ(limited->GetNumberOfPoints(), expected->GetNumberOfPoints());
  EXPECT_EQ(limited->GetPoint(5)[0], expected->GetPoint(5)[0]);
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
