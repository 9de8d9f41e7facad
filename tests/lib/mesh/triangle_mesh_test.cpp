#include "medial/error.h"
#include "medial/triangle_mesh.h"
#include "support/errors.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <random>
#include <set>

using namespace medial;
using namespace medial::test;

namespace
{

constexpr double kPi = 3.14159265358979323846;

MeshInput polygonInput(const std::vector<Point3>& corners)
{
  MeshInput input;
  input.points = corners;
  std::vector<std::int64_t> ids(corners.size());
  for (std::size_t i = 0; i < ids.size(); ++i)
  {
    ids[i] = static_cast<std::int64_t>(i);
  }
  input.polygons.append(ids, 0);
  return input;
}

/// Twice the vector area of each triangle, summed; and its lengths summed.
std::pair<Point3, double> areas(const TriangleMesh& mesh)
{
  Point3 sum{};
  double total = 0.0;
  for (const auto& t : mesh.triangles)
  {
    const Point3& a = mesh.points[t[0]];
    const Point3& b = mesh.points[t[1]];
    const Point3& c = mesh.points[t[2]];
    Point3 area{};
    for (int i = 0; i < 3; ++i)
    {
      const int u = (i + 1) % 3;
      const int v = (i + 2) % 3;
      area[i] = 0.5 * ((b[u] - a[u]) * (c[v] - a[v]) - (b[v] - a[v]) * (c[u] - a[u]));
      sum[i] += area[i];
    }
    total += std::hypot(area[0], area[1], area[2]);
  }
  return { sum, total };
}

/// A triangulation is right when no triangle is flipped: the areas add up without cancelling.
void expectCovers(const std::vector<Point3>& polygon, double area)
{
  const TriangleMesh mesh = buildTriangleMesh(polygonInput(polygon));
  const auto [sum, total] = areas(mesh);
  EXPECT_EQ(mesh.triangles.size(), polygon.size() - 2);
  EXPECT_NEAR(total, area, 1e-9 * area);
  EXPECT_NEAR(std::hypot(sum[0], sum[1], sum[2]), area, 1e-9 * area);
}

/// The planar polygon, tilted so that no axis is special.
std::vector<Point3> tilted(const std::vector<std::array<double, 2>>& polygon)
{
  std::vector<Point3> result;
  for (const auto& [x, y] : polygon)
  {
    result.push_back({ 0.6 * x + 5.0, 0.48 * x + 0.8 * y, 0.64 * x - 0.6 * y - 2.0 });
  }
  return result;
}

std::string refusalOf(const MeshInput& input)
{
  return messageOf([&] { buildTriangleMesh(input); });
}

} // namespace

TEST(TriangleMesh, WeldsBitEqualPoints)
{
  const TriangleMesh cube = box({ 1, 2, 3 });
  const TriangleMesh mesh = buildTriangleMesh(unwelded(cube));
  EXPECT_EQ(mesh.points.size(), 8u);
  EXPECT_EQ(mesh.triangles.size(), 12u);
  EXPECT_EQ(mesh.weldedPoints, 36 - 8);
  EXPECT_EQ(mesh.bounds().min, (Point3{ -1, -2, -3 }));
  EXPECT_EQ(mesh.bounds().max, (Point3{ 1, 2, 3 }));
}

TEST(TriangleMesh, NegativeZeroEqualsZero)
{
  const TriangleMesh mesh =
    makeMesh({ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { -0.0, 0, -0.0 }, { 0, 0, 1 } },
      { { 0, 1, 2 }, { 3, 2, 4 } });
  EXPECT_EQ(mesh.points.size(), 4u);
  EXPECT_EQ(mesh.pointOfInput, (std::vector<int>{ 0, 1, 2, 0, 3 }));
}

TEST(TriangleMesh, NearbyPointsStayApart)
{
  const double next = std::nextafter(1.0, 2.0);
  const TriangleMesh mesh = makeMesh({ { 0, 0, 0 }, { 1, 0, 0 }, { next, 0, 0 }, { 0, 1, 0 } },
    { { 0, 1, 3 }, { 0, 2, 3 } });
  EXPECT_EQ(mesh.points.size(), 4u);
  EXPECT_EQ(mesh.weldedPoints, 0);
}

TEST(TriangleMesh, LeavesOutUnusedPoints)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const TriangleMesh mesh = makeMesh(
    { { nan, 0, 0 }, { 0, 0, 0 }, { 9, 9, 9 }, { 1, 0, 0 }, { 0, 1, 0 } }, { { 1, 3, 4 } });
  EXPECT_EQ(mesh.points.size(), 3u);
  EXPECT_EQ(mesh.pointOfInput, (std::vector<int>{ -1, 0, -1, 1, 2 }));
}

TEST(TriangleMesh, KeepsTheCallersCellIds)
{
  MeshInput input;
  input.points = { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 }, { 5, 5, 5 } };
  input.polygons.append({ 0, 1, 2, 3 }, 70);
  input.polygons.append({ 0, 1, 1 }, 71);
  input.lines.append({ 0, 4, 2 }, 50);
  input.verts.append({ 4, 0 }, 60);
  const TriangleMesh mesh = buildTriangleMesh(input);
  EXPECT_EQ(mesh.triangleCells, (std::vector<std::int64_t>{ 70, 70 }));
  EXPECT_EQ(mesh.segmentCells, (std::vector<std::int64_t>{ 71, 50, 50 }));
  EXPECT_EQ(mesh.vertexCells, (std::vector<std::int64_t>{ 60, 60 }));
}

TEST(TriangleMesh, CollapsedTrianglesBecomeSegmentsAndPoints)
{
  const TriangleMesh mesh =
    makeMesh({ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 0, 0 } }, { { 0, 1, 2 }, { 2, 0, 2 }, { 1, 1, 0 } });
  EXPECT_TRUE(mesh.triangles.empty());
  EXPECT_EQ(mesh.segments, (std::vector<std::array<int, 2>>{ { 0, 1 }, { 1, 0 } }));
  EXPECT_EQ(mesh.vertices, (std::vector<int>{ 0 }));
  EXPECT_EQ(mesh.degenerateTriangles, 3);
}

TEST(TriangleMesh, CollinearTrianglesStayTriangles)
{
  const TriangleMesh mesh = makeMesh({ { 0, 0, 0 }, { 1, 2, 3 }, { 3, 6, 9 } }, { { 0, 1, 2 } });
  EXPECT_EQ(mesh.triangles.size(), 1u);
  EXPECT_TRUE(mesh.segments.empty());
  EXPECT_EQ(mesh.degenerateTriangles, 1);
}

TEST(TriangleMesh, AreaIsJudgedByShapeNotSize)
{
  EXPECT_TRUE(hasArea({ 0, 0, 0 }, { 1e-90, 0, 0 }, { 0, 1e-90, 0 }));
  EXPECT_TRUE(hasArea({ 0, 0, 0 }, { 1e90, 0, 0 }, { 0, 1e82, 0 }));
  EXPECT_TRUE(hasArea({ 1e6, 0, 0 }, { 1e6 + 1, 0, 0 }, { 1e6 + 0.5, 1e-6, 0 }));
  EXPECT_FALSE(hasArea({ 0, 0, 0 }, { 0.1, 0.3, 0.7 }, { 0.3, 0.9, 2.1 }));
  EXPECT_FALSE(hasArea({ 1, 1, 1 }, { 1, 1, 1 }, { 2, 2, 2 }));
}

TEST(TriangleMesh, PolylinesBecomeSegments)
{
  MeshInput input;
  input.points = { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 0, 0 }, { 2, 0, 0 } };
  input.lines.append({ 0, 1, 2, 3 }, 4);
  const TriangleMesh mesh = buildTriangleMesh(input);
  EXPECT_EQ(mesh.segments, (std::vector<std::array<int, 2>>{ { 0, 1 }, { 1, 2 } }));
  EXPECT_EQ(mesh.vertices, (std::vector<int>{ 1 }));
}

// Every other triangle of a strip runs backwards; all keep the strip's id.
TEST(TriangleMesh, StripsBecomeTrianglesOfOneOrientation)
{
  MeshInput input = polygonInput({ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 } });
  input.points.insert(input.points.end(), { { 2, 0, 0 }, { 2, 1, 0 }, { 3, 0, 0 }, { 3, 1, 0 } });
  input.strips.append({ 1, 3, 2, 4 }, 7);
  input.strips.append({ 5, 6 }, 8); // no triangle, so its points are not used
  const TriangleMesh mesh = buildTriangleMesh(input);
  EXPECT_EQ(mesh.triangles,
    (std::vector<std::array<int, 3>>{ { 0, 1, 2 }, { 1, 3, 2 }, { 3, 4, 2 } }));
  EXPECT_EQ(mesh.triangleCells, (std::vector<std::int64_t>{ 0, 7, 7 }));
  EXPECT_EQ(mesh.points.size(), 5U);
  input.strips.offsets.back() = 9;
  EXPECT_THROW(buildTriangleMesh(input), Error);
}

TEST(TriangleMesh, RepeatedTrianglesAreKept)
{
  const TriangleMesh mesh =
    makeMesh({ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 } }, { { 0, 1, 2 }, { 0, 1, 2 }, { 2, 1, 0 } });
  EXPECT_EQ(mesh.triangles.size(), 3u);
}

TEST(TriangleMesh, RefusesCoordinatesThatAreNotFinite)
{
  MeshInput input = toInput(box({ 1, 1, 1 }));
  input.points[7] = { std::numeric_limits<double>::quiet_NaN(), 0, 0 };
  EXPECT_EQ(refusalOf(input), "point 7 has a coordinate that is not finite: (nan, 0, 0)");
  input.points[7] = { 0, -std::numeric_limits<double>::infinity(), 1.5 };
  EXPECT_EQ(refusalOf(input), "point 7 has a coordinate that is not finite: (0, -inf, 1.5)");
}

TEST(TriangleMesh, RefusesCoordinatesWhoseSquaresDoNotFitSinglePrecision)
{
  MeshInput input = toInput(box({ 1, 1, 1 }));
  for (Point3& point : input.points)
  {
    point = { 1e18 * point[0], 1e18 * point[1], 1e18 * point[2] };
  }
  EXPECT_EQ(buildTriangleMesh(input).triangles.size(), 12U);
  input.points[3] = { 0, -1.5e18, 0 };
  EXPECT_EQ(refusalOf(input),
    "point 3 has a coordinate that is beyond 1e+18 in magnitude: (0, -1.5e+18, 0)");
}

TEST(TriangleMesh, RefusesBoundsThatSinglePrecisionCannotMeasure)
{
  MeshInput input = toInput(box({ 1, 1, 1 }));
  for (Point3& point : input.points)
  {
    point = { 1e-50 * point[0], 1e-50 * point[1], 1e-50 * point[2] };
  }
  EXPECT_EQ(refusalOf(input),
    "the bounds of the points have a diagonal of 3.4641e-50, less than 1e-18");
}

TEST(TriangleMesh, RefusesPointIdsOutOfRange)
{
  MeshInput input;
  input.points.resize(12);
  input.polygons.append({ 0, 1, 99 }, 3);
  EXPECT_EQ(refusalOf(input), "cell 3 names point 99, but there are only 12 points");
  input.polygons = {};
  input.verts.append({ -1 }, 5);
  EXPECT_EQ(refusalOf(input), "cell 5 names point -1, but there are only 12 points");
}

TEST(TriangleMesh, RefusesInputsWithoutCells)
{
  MeshInput input;
  EXPECT_EQ(refusalOf(input), "the mesh has no cells");
  input.points = { { 0, 0, 0 } };
  input.polygons.append({}, 0);
  EXPECT_EQ(refusalOf(input), "the mesh has no cells");
}

TEST(TriangleMesh, RefusesInconsistentOffsets)
{
  MeshInput input = toInput(box({ 1, 1, 1 }));
  input.polygons.offsets.back() = 1000;
  EXPECT_EQ(refusalOf(input), "the offsets of the polygons do not fit their ids and connectivity");
}

TEST(Triangulation, ConcaveQuadIsSplitAtItsReflexCorner)
{
  const std::vector<std::array<double, 2>> arrow = { { 0, 0 }, { 2, 1 }, { 0, 2 }, { 0.5, 1 } };
  for (std::size_t first = 0; first < 4; ++first)
  {
    auto corners = arrow;
    std::rotate(corners.begin(), corners.begin() + first, corners.end());
    expectCovers(tilted(corners), 1.5);
  }
}

TEST(Triangulation, QuadWithAFlatCornerHasNoFlatTriangle)
{
  const TriangleMesh mesh =
    buildTriangleMesh(polygonInput(tilted({ { 0, 0 }, { 2, 0 }, { 0, 2 }, { 0, 1 } })));
  EXPECT_EQ(mesh.triangles.size(), 2u);
  EXPECT_EQ(mesh.degenerateTriangles, 0);
  EXPECT_NEAR(areas(mesh).second, 2.0, 1e-12);
}

TEST(Triangulation, QuadTakesTheShorterDiagonal)
{
  const TriangleMesh mesh =
    buildTriangleMesh(polygonInput({ { 0, 0, 0 }, { 3, -1, 0 }, { 4, 0, 0 }, { 3, 1, 0 } }));
  for (const auto& t : mesh.triangles)
  {
    EXPECT_EQ(std::count(t.begin(), t.end(), 1) + std::count(t.begin(), t.end(), 3), 2);
  }
}

// Faces of a double-sided mesh, whose copies cancel each other only as the same triangles.
TEST(Triangulation, FirstCornerAndDirectionDoNotMatter)
{
  for (const std::vector<std::array<double, 2>>& polygon :
    { std::vector<std::array<double, 2>>{ { 0, 0 }, { 4, 0 }, { 4, 2 }, { 0, 2 } },
      { { 0, 0 }, { 3, 0 }, { 3, 3 }, { 2, 3 }, { 2, 1 }, { 0, 1 } } })
  {
    std::vector<Point3> corners = tilted(polygon);
    std::set<std::set<std::set<Point3>>> ways;
    for (std::size_t way = 0; way < 2 * corners.size(); ++way)
    {
      const TriangleMesh mesh = buildTriangleMesh(polygonInput(corners));
      std::set<std::set<Point3>> triangles;
      for (const auto& t : mesh.triangles)
      {
        triangles.insert({ mesh.points[t[0]], mesh.points[t[1]], mesh.points[t[2]] });
      }
      ways.insert(triangles);
      const auto [sum, total] = areas(mesh);
      EXPECT_NEAR(std::hypot(sum[0], sum[1], sum[2]), total, 1e-12); // none is turned over
      std::rotate(corners.begin(), corners.begin() + 1, corners.end());
      if (way == corners.size())
      {
        std::reverse(corners.begin(), corners.end());
      }
    }
    EXPECT_EQ(ways.size(), 1u);
  }
}

TEST(Triangulation, CombKeepsItsArea)
{
  std::vector<std::array<double, 2>> comb = { { 20, -1 }, { 20, 0 } };
  for (int tooth = 19; tooth >= 0; --tooth)
  {
    comb.insert(comb.end(), { { tooth + 0.75, 5.0 }, { tooth + 0.5, 0.0 } });
  }
  comb.insert(comb.end(), { { 0, 0 }, { 0, -1 } });
  // 19 teeth stand on a base of one unit, the first on half of one.
  expectCovers(tilted(comb), 20.0 + 0.5 * 5.0 * (20.0 - 0.5));
}

TEST(Triangulation, StarsKeepTheirArea)
{
  for (const double inner : { 0.05, 0.5, 0.99 })
  {
    std::vector<std::array<double, 2>> star;
    const int tips = 101;
    for (int i = 0; i < 2 * tips; ++i)
    {
      const double radius = i % 2 == 0 ? 1.0 : inner;
      const double angle = kPi * i / tips;
      star.push_back({ radius * std::cos(angle), radius * std::sin(angle) });
    }
    expectCovers(tilted(star), tips * inner * std::sin(kPi / tips));
  }
}

TEST(Triangulation, FlatCornersMakeNoFlatTriangles)
{
  std::vector<std::array<double, 2>> square;
  for (int i = 0; i < 8; ++i)
  {
    square.push_back({ i / 8.0, 0 });
  }
  for (int i = 0; i < 8; ++i)
  {
    square.push_back({ 1, i / 8.0 });
  }
  for (int i = 8; i > 0; --i)
  {
    square.push_back({ i / 8.0, 1 });
  }
  for (int i = 8; i > 0; --i)
  {
    square.push_back({ 0, i / 8.0 });
  }
  expectCovers(tilted(square), 1.0);
  EXPECT_EQ(buildTriangleMesh(polygonInput(tilted(square))).degenerateTriangles, 0);
}

TEST(Triangulation, CornersThatRoundingTakesOffALineCauseNoOverlap)
{
  std::mt19937 random(7);
  const auto step = [&] { return static_cast<double>(random() % 3); };
  for (int i = 0; i < 5000; ++i)
  {
    const int columns = 3 + static_cast<int>(random() % 15);
    std::vector<std::array<double, 2>> polygon(2 * columns);
    double area = 0.0;
    for (int x = 0; x < columns; ++x)
    {
      const double height = 1.0 + step();
      const double depth = step();
      polygon[x] = { static_cast<double>(x), -depth };
      polygon[2 * columns - 1 - x] = { static_cast<double>(x), height };
      area += (x == 0 || x + 1 == columns ? 0.5 : 1.0) * (height + depth);
    }
    expectCovers(tilted(polygon), area);
  }
}

TEST(Triangulation, KeyholePolygonLeavesItsHoleOpen)
{
  expectCovers(tilted({ { 0, 0 }, { 4, 0 }, { 4, 4 }, { 0, 4 }, { 0, 0 }, { 1, 1 }, { 1, 3 },
                 { 3, 3 }, { 3, 1 }, { 1, 1 } }),
    12.0);
}

TEST(Triangulation, PolygonsThatAreNotSimpleStillGiveTriangles)
{
  const TriangleMesh crossing = buildTriangleMesh(
    polygonInput({ { 0, 0, 0 }, { 1, 1, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { -1, 2, 0 } }));
  EXPECT_EQ(crossing.triangles.size(), 3u);
  const TriangleMesh straight = buildTriangleMesh(
    polygonInput({ { 0, 0, 0 }, { 1, 0, 0 }, { 2, 0, 0 }, { 3, 0, 0 }, { 4, 0, 0 } }));
  EXPECT_EQ(straight.triangles.size(), 3u);
  EXPECT_EQ(straight.degenerateTriangles, 3);
}

std::vector<Point3> tangledPolygon(int corners)
{
  std::mt19937 random(3);
  const auto next = [&] { return static_cast<double>(random() % 4096); };
  std::vector<Point3> polygon;
  for (int i = 0; i < corners; ++i)
  {
    const double x = next();
    polygon.push_back({ x, next(), 0.0 });
  }
  return polygon;
}

// Each took minutes: the effort grew with the cube of the corners.
TEST(Triangulation, TangledPolygonsOfManyCornersTakeSecondsOrAreRefused)
{
  const TriangleMesh mesh = buildTriangleMesh(polygonInput(tangledPolygon(12000)));
  EXPECT_EQ(mesh.triangles.size(), 11998u);
  EXPECT_THROW(buildTriangleMesh(polygonInput(tangledPolygon(100000))), Error);
}

TEST(Triangulation, SizeAndPlaceDoNotMatter)
{
  for (const double size : { 1e-17, 1e-6, 1.0, 1e6, 1e17 })
  {
    const std::vector<Point3> polygon = { { 0, 0, 0 }, { size, 0, 0 }, { size, 0, size },
      { 0.5 * size, 0, 0.25 * size }, { 0, 0, size } };
    const TriangleMesh mesh = buildTriangleMesh(polygonInput(polygon));
    EXPECT_NEAR(areas(mesh).second / size / size, 0.625, 1e-12);
  }
}

TEST(TriangleMesh, WeldsAMillionPointsQuickly)
{
  MeshInput input;
  for (int i = 0; i < 500; ++i)
  {
    for (int j = 0; j < 500; ++j)
    {
      const auto first = static_cast<std::int64_t>(input.points.size());
      for (const auto& [x, y] : { std::pair{ i, j }, { i + 1, j }, { i + 1, j + 1 }, { i, j + 1 } })
      {
        input.points.push_back({ 0.1 * x, 0.1 * y, 0.01 * x * y });
      }
      input.polygons.append({ first, first + 1, first + 2, first + 3 }, input.polygons.size());
    }
  }
  const auto start = std::chrono::steady_clock::now();
  const TriangleMesh mesh = buildTriangleMesh(input);
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
  EXPECT_EQ(mesh.points.size(), 501u * 501u);
  EXPECT_EQ(mesh.triangles.size(), 500000u);
  // About 0.1 s; the bound only tells linear from quadratic, on slow machines too.
  EXPECT_LT(seconds.count(), 10.0);
}
