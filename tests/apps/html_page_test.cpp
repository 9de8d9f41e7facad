#include "scalar_bar.h"
#include "web/html_mesh.h"
#include "web/html_page.h"
#include "web/web_files.h"

#include "support/shapes.h"

#include <vtkBase64Utilities.h>
#include <vtkCellArray.h>
#include <vtkDoubleArray.h>
#include <vtkFloatArray.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <nlohmann/json.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <optional>
#include <regex>

namespace medial::test
{
namespace
{

using Json = nlohmann::json;
using app::makeHtml;

constexpr double kSteps = 65535.0;
const std::string kBundle = "var vtk = {};";

float angleAt(double x)
{
  return static_cast<float>(60.0 + 100.0 * x * x);
}

// A square of n x n quads in the plane z = 5 with corners (0, 0) and (1, 1), a line and a point.
vtkSmartPointer<vtkPolyData> sheet(int n)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkFloatArray> radius, angle, lambda;
  radius->SetName("Radius");
  angle->SetName("SeparationAngle");
  lambda->SetName("Lambda");
  for (int i = 0; i <= n; ++i)
  {
    for (int j = 0; j <= n; ++j)
    {
      const double x = static_cast<double>(i) / n;
      const double y = static_cast<double>(j) / n;
      points->InsertNextPoint(x, y, 5.0);
      radius->InsertNextValue(static_cast<float>(2.0 + x * y));
      angle->InsertNextValue(angleAt(x));
      lambda->InsertNextValue(static_cast<float>(y));
    }
  }
  vtkNew<vtkCellArray> quads, lines, vertices;
  for (int i = 0; i < n; ++i)
  {
    for (int j = 0; j < n; ++j)
    {
      const vtkIdType first = i * (n + 1) + j;
      quads->InsertNextCell({ first, first + n + 1, first + n + 2, first + 1 });
    }
  }
  lines->InsertNextCell({ 0, 1 });
  vertices->InsertNextCell({ 3 });
  auto axis = vtkSmartPointer<vtkPolyData>::New();
  axis->SetPoints(points);
  axis->SetPolys(quads);
  axis->SetLines(lines);
  axis->SetVerts(vertices);
  axis->GetPointData()->AddArray(radius);
  axis->GetPointData()->AddArray(angle);
  axis->GetPointData()->AddArray(lambda);
  return axis;
}

vtkSmartPointer<vtkPolyData> emptyAxis()
{
  auto axis = sheet(1);
  axis->SetPoints(vtkNew<vtkPoints>());
  axis->SetPolys(nullptr);
  axis->SetLines(nullptr);
  axis->SetVerts(nullptr);
  for (int i = 0; i < 3; ++i)
  {
    axis->GetPointData()->GetArray(i)->SetNumberOfTuples(0);
  }
  return axis;
}

template <typename T>
std::vector<T> decoded(const Json& base64)
{
  const auto text = base64.get<std::string>();
  std::vector<unsigned char> bytes(text.size() + 3);
  const std::size_t length = vtkBase64Utilities::DecodeSafely(
    reinterpret_cast<const unsigned char*>(text.data()), text.size(), bytes.data(), bytes.size());
  std::vector<T> values(length / sizeof(T));
  std::memcpy(values.data(), bytes.data(), values.size() * sizeof(T));
  return values;
}

// The JSON that the browser gets from the page.
Json dataOf(const std::string& page)
{
  const std::string start = R"(<script id="data" type="application/json">)";
  const std::size_t first = page.find(start) + start.size();
  return Json::parse(page.substr(first, page.find("</script>", first) - first));
}

std::vector<Point3> pointsOf(const Json& data, const char* mesh)
{
  const auto steps = decoded<std::uint16_t>(data[mesh]["points"]);
  std::vector<Point3> points(steps.size() / 3);
  for (std::size_t i = 0; i < steps.size(); ++i)
  {
    points[i / 3][i % 3] = data["frame"]["origin"][i % 3].get<double>() +
      data["frame"]["step"][i % 3].get<double>() * steps[i];
  }
  return points;
}

std::vector<double> valuesOf(const Json& array)
{
  std::vector<double> values;
  for (const std::uint16_t steps : decoded<std::uint16_t>(array["values"]))
  {
    values.push_back(array["origin"].get<double>() + array["step"].get<double>() * steps);
  }
  return values;
}

int occurrences(const std::string& text, const std::string& pattern)
{
  const std::regex expression(pattern, std::regex::icase);
  return static_cast<int>(std::distance(std::sregex_iterator(text.begin(), text.end(), expression),
    std::sregex_iterator()));
}

// The minimum separation angle of the corners of each triangle, in the order of the page.
std::vector<double> minAngles(const Json& data)
{
  const auto angles = valuesOf(data["axis"]["arrays"][1]);
  const auto corners = decoded<std::uint32_t>(data["axis"]["triangles"]);
  std::vector<double> min;
  for (std::size_t t = 0; t < corners.size(); t += 3)
  {
    min.push_back(
      std::min({ angles.at(corners[t]), angles.at(corners[t + 1]), angles.at(corners[t + 2]) }));
  }
  return min;
}

class HtmlPage : public ::testing::Test
{
protected:
  TriangleMesh surface = box({ 1.0, 0.7, 6.0 });
  std::string page = makeHtml(surface, sheet(10), nullptr,
    { "box.obj", "angle 60", "grid 4 x 5 x 6" }, 60.0, kBundle)
                       .html;
  Json data = dataOf(page);
};

TEST_F(HtmlPage, LoadsNothing)
{
  EXPECT_EQ(occurrences(page, R"(\b(src|href|srcset|action)\s*=\s*["'])"), 0);
  EXPECT_EQ(occurrences(page, R"(@import|url\(|https?://|fetch\(|XMLHttpRequest|import\s*\()"), 0);
  EXPECT_EQ(occurrences(page, "Content-Security-Policy\" content=\"default-src 'none'"), 1);
}

TEST_F(HtmlPage, IsWhole)
{
  EXPECT_EQ(page.rfind("<!DOCTYPE html>", 0), 0U);
  EXPECT_EQ(occurrences(page, "<script"), 3);
  EXPECT_EQ(occurrences(page, "</script>"), 3);
  EXPECT_EQ(occurrences(page, R"(\{\{\w+\}\})"), 0);
  EXPECT_NE(page.find(kBundle), std::string::npos);
  for (const char* file : { "style.css", "decode.js", "scene.js", "controls.js" })
  {
    EXPECT_NE(page.find(app::webFile(file)), std::string::npos) << file;
  }
}

TEST_F(HtmlPage, KeepsPositionsToHalfAStep)
{
  const auto points = pointsOf(data, "surface");
  ASSERT_EQ(points.size(), surface.points.size());
  const Point3 sides{ 2.0, 1.7, 12.0 }; // of the bounds; the sheet goes to y = 1
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    for (int k = 0; k < 3; ++k)
    {
      ASSERT_NEAR(points[i][k], surface.points[i][k], 0.5001 * sides[k] / kSteps);
    }
  }
  EXPECT_EQ(decoded<std::uint32_t>(data["surface"]["triangles"]).size(), 36U);
}

TEST_F(HtmlPage, KeepsTheArraysOfTheAxis)
{
  const auto points = pointsOf(data, "axis");
  const Json& arrays = data["axis"]["arrays"];
  ASSERT_EQ(arrays.size(), 3U);
  const auto radius = valuesOf(arrays[0]);
  const auto angle = valuesOf(arrays[1]);
  const auto lambda = valuesOf(arrays[2]);
  ASSERT_EQ(points.size(), 121U);
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    const auto [x, y, z] = points[i];
    ASSERT_NEAR(z, 5.0, 1e-3);
    ASSERT_NEAR(radius[i], 2.0 + x * y, 1e-4);
    ASSERT_NEAR(angle[i], angleAt(x), 0.01);
    ASSERT_NEAR(lambda[i], y, 1e-4);
  }
  EXPECT_EQ(arrays[0]["unit"], "world units");
  EXPECT_EQ(arrays[1]["unit"], "degrees");
}

// As in pictures and in the viewer.
TEST_F(HtmlPage, ScalesBeginAtZeroAndHaveRoundNumbers)
{
  const Json& arrays = data["axis"]["arrays"];
  EXPECT_EQ(arrays[0]["max"], 3.0);
  EXPECT_EQ(arrays[0]["ticks"].dump(), R"([[0.0,"0"],[1.0,"1"],[2.0,"2"],[3.0,"3"]])");
  EXPECT_EQ(arrays[1]["max"], 180.0);
  EXPECT_EQ(arrays[1]["ticks"].dump(),
    R"([[0.0,"0"],[50.0,"50"],[100.0,"100"],[150.0,"150"],[180.0,"180"]])");
  for (const Json& array : arrays)
  {
    std::vector<double> ticks;
    for (const Json& tick : array["ticks"])
    {
      ticks.push_back(tick[0]);
    }
    EXPECT_EQ(ticks, app::scaleTicks(array["max"])) << array["name"];
  }
}

TEST_F(HtmlPage, ScalesOfCoarserMeshesStay)
{
  const auto axis = sheet(300);
  const Json coarse =
    dataOf(makeHtml(surface, axis, nullptr, { "box" }, 60.0, kBundle, 1'000'000).html);
  ASSERT_EQ(coarse["simplified"], true);
  const auto radius = valuesOf(coarse["axis"]["arrays"][0]);
  EXPECT_LT(*std::max_element(radius.begin(), radius.end()), 3.0); // its corner is not kept
  EXPECT_EQ(coarse["axis"]["arrays"][0]["max"], 3.0);
}

TEST_F(HtmlPage, TrianglesCoverTheSheetThoseOfWideAnglesFirst)
{
  const auto points = pointsOf(data, "axis");
  const auto corners = decoded<std::uint32_t>(data["axis"]["triangles"]);
  ASSERT_EQ(corners.size(), 600U);
  double area = 0.0;
  for (std::size_t t = 0; t < corners.size(); t += 3)
  {
    const Point3& a = points.at(corners[t]);
    const Point3& b = points.at(corners[t + 1]);
    const Point3& c = points.at(corners[t + 2]);
    area += 0.5 * std::abs((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]));
  }
  EXPECT_NEAR(area, 1.0, 1e-3);
  const auto angles = minAngles(data);
  EXPECT_TRUE(std::is_sorted(angles.rbegin(), angles.rend()));
  EXPECT_GT(angles.front(), 130.0);
  EXPECT_NEAR(angles.back(), 60.0, 0.01);
  EXPECT_EQ(decoded<std::uint32_t>(data["axis"]["lines"]), (std::vector<std::uint32_t>{ 0, 1 }));
  EXPECT_EQ(decoded<std::uint32_t>(data["axis"]["vertices"]), (std::vector<std::uint32_t>{ 3 }));
}

TEST_F(HtmlPage, NoTextEndsAScript)
{
  const std::string title = "</script><b>\"\\ & <!-- \xC3\xA9 \xFF";
  const std::string hostile =
    makeHtml(surface, sheet(2), nullptr, { title }, 60.0, "a = '</SCRIPT><!--';").html;
  EXPECT_EQ(occurrences(hostile, "</script"), 3);
  EXPECT_EQ(occurrences(hostile, "<!--"), 1); // the page's own
  EXPECT_NE(hostile.find(R"(a = '<\/SCRIPT><\!--';)"), std::string::npos);
  EXPECT_EQ(dataOf(hostile)["title"], "</script><b>\"\\ & <!-- \xC3\xA9 \xEF\xBF\xBD");
}

TEST_F(HtmlPage, SaysHowTheAxisWasComputed)
{
  EXPECT_EQ(data["title"], "box.obj");
  EXPECT_EQ(data["settings"], Json({ "angle 60", "grid 4 x 5 x 6" }));
}

TEST_F(HtmlPage, AnEmptyAxisIsNone)
{
  const Json empty = dataOf(makeHtml(surface, emptyAxis(), nullptr, { "box" }, 60.0, kBundle).html);
  EXPECT_EQ(empty["axis"]["points"], "");
  EXPECT_EQ(empty["axis"]["triangles"], "");
  EXPECT_EQ(empty["axis"]["arrays"][1]["values"], "");
  EXPECT_EQ(empty["axis"]["arrays"][0]["max"], 1.0);
  EXPECT_EQ(pointsOf(empty, "surface").size(), 8U);
}

TEST_F(HtmlPage, HoldsTheSkeletonIfThereIsOne)
{
  EXPECT_FALSE(data.contains("skeleton"));
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkDoubleArray> radius;
  vtkNew<vtkIntArray> degree;
  radius->SetName("Radius");
  degree->SetName("Degree");
  vtkNew<vtkCellArray> lines;
  lines->InsertNextCell(11);
  for (int i = 0; i <= 10; ++i)
  {
    lines->InsertCellPoint(points->InsertNextPoint(0.1 * i, 0.2, 3.0));
    radius->InsertNextValue(1.0 + 0.1 * i);
    degree->InsertNextValue(i % 10 == 0 ? 1 : 2);
  }
  vtkNew<vtkPolyData> line;
  line->SetPoints(points);
  line->SetLines(lines);
  line->GetPointData()->AddArray(radius);
  line->GetPointData()->AddArray(degree);
  const Json with = dataOf(makeHtml(surface, sheet(2), line, { "box" }, 60.0, kBundle).html);
  const auto places = pointsOf(with, "skeleton");
  const auto radii = valuesOf(with["skeleton"]["arrays"][0]);
  ASSERT_EQ(radii.size(), places.size());
  for (std::size_t i = 0; i < places.size(); ++i)
  {
    EXPECT_LT(std::hypot(places[i][1] - 0.2, places[i][2] - 3.0), 0.01);
    EXPECT_NEAR(radii[i], 1.0 + places[i][0], 1e-3);
  }
  EXPECT_GT(decoded<std::uint32_t>(with["skeleton"]["triangles"]).size(), 100U);
  const auto ends = decoded<std::uint32_t>(with["skeleton"]["vertices"]);
  ASSERT_EQ(ends.size(), 2U);
  EXPECT_NEAR(std::abs(places.at(ends[1])[0] - places.at(ends[0])[0]), 1.0, 1e-3);
}

// Half the sides of boxes; a fifth decides.
TEST_F(HtmlPage, SaysWhatIsFlat)
{
  const auto isFlat = [](const Point3& half)
  {
    const app::HtmlPage made = makeHtml(box(half), emptyAxis(), nullptr, { "box" }, 60.0, kBundle);
    return dataOf(made.html)["flat"].get<bool>();
  };
  EXPECT_FALSE(data["flat"]);
  EXPECT_TRUE(isFlat({ 1.0, 0.6, 0.05 }));
  EXPECT_TRUE(isFlat({ 3.0, 0.19, 1.0 }));
  EXPECT_FALSE(isFlat({ 3.0, 0.21, 1.0 }));
  EXPECT_FALSE(isFlat({ 0.1, 0.1, 1.0 }));
}

TEST_F(HtmlPage, WithoutASurfaceTheAxisIsLookedAt)
{
  EXPECT_EQ(dataOf(makeHtml({}, sheet(2), nullptr, { "" }, 60.0, kBundle).html)["flat"], true);
  EXPECT_EQ(dataOf(makeHtml({}, emptyAxis(), nullptr, { "" }, 60.0, kBundle).html)["flat"], false);
}

TEST_F(HtmlPage, LooksFromWherePicturesDo)
{
  const app::HtmlPage plate =
    makeHtml(box({ 1.0, 0.6, 0.05 }), sheet(2), nullptr, { "plate" }, 60.0, kBundle);
  const Json views = dataOf(plate.html)["views"];
  const auto expectView = [&](const char* name, const Point3& direction, const Point3& up)
  {
    for (int k = 0; k < 3; ++k)
    {
      EXPECT_NEAR(views[name]["direction"][k].get<double>(), direction[k], 1e-9) << name;
      EXPECT_NEAR(views[name]["up"][k].get<double>(), up[k], 1e-9) << name;
    }
  };
  const auto sine = [](double degrees) { return std::sin(degrees * std::acos(-1.0) / 180.0); };
  const auto cosine = [](double degrees) { return std::cos(degrees * std::acos(-1.0) / 180.0); };
  expectView("front", { -sine(25) * cosine(18), -sine(18), -cosine(25) * cosine(18) },
    { -sine(25) * sine(18), cosine(18), -cosine(25) * sine(18) });
  expectView("edge", { 0.0, cosine(12), -sine(12) }, { 0.0, sine(12), cosine(12) });
}

TEST_F(HtmlPage, SaysHowFarItRounds)
{
  const std::string notes = data["notes"].dump();
  EXPECT_NE(notes.find("rounded by up to 9.16e-05 world units"), std::string::npos) << notes;
  EXPECT_EQ(data["simplified"], false);
  EXPECT_EQ(notes.find("simplified"), std::string::npos);
}

TEST(HtmlPageLimit, CoarserMeshesKeepItAndThePageSaysSo)
{
  const TriangleMesh sphere = icosphere(1.0, 6); // 81,920 triangles
  const auto axis = sheet(300);                  // 180,000
  constexpr std::size_t kLimit = 1'000'000;
  const app::HtmlPage whole = makeHtml(sphere, axis, nullptr, { "sphere" }, 60.0, kBundle);
  EXPECT_GT(whole.html.size(), 2 * kLimit);
  EXPECT_EQ(whole.simplifications, std::vector<std::string>());
  const app::HtmlPage page = makeHtml(sphere, axis, nullptr, { "sphere" }, 60.0, kBundle, kLimit);
  EXPECT_LT(page.html.size(), kLimit);
  EXPECT_GT(page.html.size(), kLimit / 3);
  const Json data = dataOf(page.html);
  const std::string notes = data["notes"].dump();
  const auto angles = minAngles(data);
  EXPECT_EQ(data["simplified"], true);
  EXPECT_TRUE(std::is_sorted(angles.rbegin(), angles.rend()));
  const auto count = [&](const char* mesh, const char* kind, int corners)
  {
    const auto cells = decoded<std::uint32_t>(data[mesh][kind]).size() / corners;
    return std::to_string(cells);
  };
  const std::string surfaceNote = "the surface was simplified from 81920 to " +
    count("surface", "triangles", 3) + " triangles: points that share a box of side 0.0";
  const std::string axisNote = "the medial axis was simplified from 180002 to ";
  EXPECT_NE(notes.find("To keep this file small " + surfaceNote), std::string::npos) << notes;
  EXPECT_NE(notes.find("To keep this file small " + axisNote), std::string::npos) << notes;
  EXPECT_NE(notes.find(" triangles, lines and points: "), std::string::npos) << notes;
  ASSERT_EQ(page.simplifications.size(), 2U);
  EXPECT_EQ(page.simplifications[0].rfind(surfaceNote, 0), 0U) << page.simplifications[0];
  EXPECT_EQ(page.simplifications[1].rfind(axisNote, 0), 0U) << page.simplifications[1];
}

TEST(HtmlMesh, CoarsePointsAreNearAllOthersAndCellsStillCover)
{
  const auto axis = sheet(64);
  app::HtmlMesh mesh = app::htmlMesh(axis);
  const app::HtmlMesh fine = mesh;
  const std::size_t limit = fine.bytes() / 8;
  const double side = app::coarsen(mesh, limit).value();
  EXPECT_LE(mesh.bytes(), limit);
  EXPECT_GT(side, 1.0 / 64.0);
  EXPECT_LT(side, 0.1);
  for (const Point3& point : fine.points)
  {
    const bool near = std::any_of(mesh.points.begin(), mesh.points.end(),
      [&](const Point3& kept)
      { return std::hypot(kept[0] - point[0], kept[1] - point[1]) <= side * std::sqrt(2.0); });
    ASSERT_TRUE(near);
  }
  double area = 0.0;
  for (const auto& [a, b, c] : mesh.triangles)
  {
    const Point3& p = mesh.points.at(a);
    const Point3& q = mesh.points.at(b);
    const Point3& r = mesh.points.at(c);
    area += 0.5 * std::abs((q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0]));
  }
  EXPECT_NEAR(area, 1.0, 4.0 * side);
  ASSERT_EQ(mesh.arrays[1].values.size(), mesh.points.size());
  for (std::size_t i = 0; i < mesh.points.size(); ++i)
  {
    ASSERT_FLOAT_EQ(mesh.arrays[1].values[i], angleAt(mesh.points[i][0]));
  }
}

// Sides of boxes would be 0, or round to it.
TEST(HtmlMesh, PointsAtOnePlaceBecomeOne)
{
  for (const double length : { 0.0, std::numeric_limits<double>::denorm_min() })
  {
    app::HtmlMesh mesh;
    mesh.points.assign(100, { 1.0, 2.0, 0.0 });
    mesh.points.back()[2] = length;
    mesh.triangles = { { 0, 1, 99 } };
    mesh.lines = { { 0, 98 } };
    mesh.vertices = { { 5 }, { 99 } };
    EXPECT_EQ(app::coarsen(mesh, 100), std::optional(0.0));
    EXPECT_EQ(mesh.points, (std::vector<Point3>{ { 1.0, 2.0, 0.0 } }));
    EXPECT_TRUE(mesh.triangles.empty());
    EXPECT_TRUE(mesh.lines.empty());
    EXPECT_EQ(mesh.vertices, (app::HtmlMesh::Cells<1>{ { 0 } }));
  }
}

TEST(HtmlMesh, SmallMeshesStay)
{
  app::HtmlMesh mesh = app::htmlMesh(sheet(4));
  EXPECT_EQ(app::coarsen(mesh, mesh.bytes()), std::nullopt);
  EXPECT_EQ(mesh.points.size(), 25U);
  EXPECT_EQ(mesh.bytes(), 25U * 12U + 32U * 12U + 8U + 4U);
}

} // namespace
} // namespace medial::test
