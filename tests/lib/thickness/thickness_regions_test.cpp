// Where solids with known walls are too thin or too thick.
#include "medial/thickness_regions.h"

#include "medial/error.h"
#include "medial/subdivision.h"

#include "support/errors.h"
#include "support/medial_truth.h"
#include "support/shapes.h"
#include "support/thickness_shapes.h"
#include "support/transforms.h"
#include "support/tubes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>
#include <string>
#include <vector>

using namespace medial;
using namespace medial::test;

namespace
{

constexpr std::array<ThicknessMethod, 3> kMethods{ ThicknessMethod::Ball, ThicknessMethod::Ray,
  ThicknessMethod::Wall };

using Regions = std::vector<ThicknessRegion>;

/// A mesh whose thickness is known.
struct Measured
{
  explicit Measured(const TriangleMesh& surface, ThicknessMethod method = ThicknessMethod::Wall,
    Side side = Side::Interior)
    : mesh(surface)
    , connectivity(analyseConnectivity(surface))
  {
    ThicknessOptions options;
    options.method = method;
    options.side = side;
    options.cells = true;
    thickness = computeThickness(mesh, connectivity, options);
  }

  Regions beyond(const ThicknessLimits& limits) const
  {
    return findThicknessRegions(mesh, thickness, limits);
  }
  Regions thin(double min) const { return this->beyond({ min, std::nullopt }); }

  TriangleMesh mesh;
  MeshConnectivity connectivity;
  Thickness thickness;
};

std::string textOf(const Regions& regions)
{
  std::ostringstream text;
  for (const ThicknessRegion& region : regions)
  {
    text << (region.thin ? "thin " : "thick ") << region.value << " at " << region.place[0] << " "
         << region.place[1] << " " << region.place[2] << ", area " << region.area << ", "
         << region.triangles.size() << " triangles\n";
  }
  return text.str();
}

void expectNone(const Regions& regions, const std::string& what)
{
  EXPECT_TRUE(regions.empty()) << what << "\n" << textOf(regions);
}

/// A rib 1 wide and 4 high on a base 3 high and 9 wide, 8 long.
TriangleMesh ribOnBase()
{
  const std::string rib = "....#....";
  const std::string base = "#########";
  return subdivided(blocks({ rib, rib, rib, rib, base, base, base }, 4.0), 2);
}

/// A regular tetrahedron with edges of 100, which has no opposite walls, and below it a fin 20 wide
/// and high and 0.5 thick.
TriangleMesh tetrahedronWithFin()
{
  constexpr double kMiddle = 28.867513459481287;
  constexpr double kFront = kMiddle - 0.25;
  constexpr double kBack = kMiddle + 0.25;
  return makeMesh({ { 0.0, 0.0, 0.0 }, { 100.0, 0.0, 0.0 }, { 50.0, 86.602540378443862, 0.0 },
                    { 50.0, kMiddle, 81.649658092772597 }, { 40.0, kFront, 0.0 },
                    { 60.0, kFront, 0.0 }, { 60.0, kBack, 0.0 }, { 40.0, kBack, 0.0 },
                    { 40.0, kFront, -20.0 }, { 60.0, kFront, -20.0 }, { 60.0, kBack, -20.0 },
                    { 40.0, kBack, -20.0 } },
    { { 5, 1, 0 }, { 4, 5, 0 }, { 6, 2, 1 }, { 5, 6, 1 }, { 7, 0, 2 }, { 4, 0, 7 }, { 6, 7, 2 },
      { 0, 1, 3 }, { 1, 2, 3 }, { 2, 0, 3 }, { 4, 8, 9 }, { 4, 9, 5 }, { 5, 9, 10 }, { 5, 10, 6 },
      { 6, 10, 11 }, { 6, 11, 7 }, { 7, 11, 8 }, { 7, 8, 4 }, { 11, 10, 9 }, { 11, 9, 8 } });
}

void expectRefused(const ThicknessLimits& limits, const std::string& words)
{
  expectError([&] { checkThicknessLimits(limits); }, ErrorCode::InvalidInput, words);
}

} // namespace

// A box is as thin as you like at its edges, whatever thickness is, but not thin.
TEST(ThicknessRegions, EdgesOfABoxDoNotCount)
{
  const TriangleMesh mesh = subdivided(box({ 2.0, 1.0, 0.5 }), 4);
  for (const ThicknessMethod method : kMethods)
  {
    for (const TriangleMesh& turned : { mesh, tilted(mesh) })
    {
      const Measured measured(turned, method);
      for (const double min : { 0.01, 0.3, 0.9 })
      {
        expectNone(measured.thin(min), std::to_string(min));
      }
    }
  }
}

TEST(ThicknessRegions, EdgeOfAWedgeDoesNotCount)
{
  for (const double angle : { 20.0, 30.0, 60.0, 90.0, 110.0 })
  {
    const TriangleMesh mesh = subdivided(wedge(angle, 2.0, 1.0), 4);
    for (const ThicknessMethod method : kMethods)
    {
      const Measured measured(mesh, method);
      for (const double min : { 0.01, 0.1, 0.2 })
      {
        expectNone(measured.thin(min),
          std::to_string(angle) + " " + std::to_string(min) + " " +
            std::to_string(static_cast<int>(method)));
      }
    }
  }
}

// A blade of 8 degrees is a wall.
TEST(ThicknessRegions, BladesCount)
{
  const TriangleMesh mesh = subdivided(wedge(8.0, 2.0, 1.0), 4);
  for (const ThicknessMethod method : kMethods)
  {
    const Regions found = Measured(mesh, method).thin(0.05);
    ASSERT_EQ(found.size(), 1U);
    EXPECT_LT(found[0].value, 0.02);
  }
}

TEST(ThicknessRegions, TipsDoNotCount)
{
  const TriangleMesh mesh = subdivided(regularTetrahedron(1.0), 4);
  for (const ThicknessMethod method : kMethods)
  {
    EXPECT_TRUE(Measured(mesh, method).thin(0.05).empty());
  }
}

TEST(ThicknessRegions, AChamferDoesNotCount)
{
  const double c = 0.05;
  const TriangleMesh mesh = subdivided(
    prism({ { -1, -0.5 }, { 1, -0.5 }, { 1, 0.5 - c }, { 1 - c, 0.5 }, { -1, 0.5 } }, 2.0), 4);
  for (const ThicknessMethod method : kMethods)
  {
    expectNone(Measured(mesh, method).thin(0.4), std::to_string(static_cast<int>(method)));
  }
}

TEST(ThicknessRegions, ARibIsOneRegionWithItsAreaAndWidth)
{
  const TriangleMesh mesh = ribOnBase();
  const Regions found = Measured(mesh).thin(2.0);
  ASSERT_EQ(found.size(), 1U) << textOf(found);
  EXPECT_TRUE(found[0].thin);
  EXPECT_NEAR(found[0].value, 1.0, 1e-6);
  // Two sides of 4 x 8, the top of 1 x 8, the ends of 4 x 1; at the root the base begins to count.
  EXPECT_NEAR(found[0].area, 2 * 32.0 + 8.0 + 2 * 4.0, 4.0);
  EXPECT_FALSE(found[0].triangles.empty());
  EXPECT_TRUE(std::is_sorted(found[0].cells.begin(), found[0].cells.end()));
  EXPECT_TRUE(Measured(mesh).thin(0.99).empty());
  // Balls and rays leave out the edges of the rib only.
  for (const ThicknessMethod method : { ThicknessMethod::Ball, ThicknessMethod::Ray })
  {
    const Regions sides = Measured(mesh, method).thin(2.0);
    ASSERT_GE(sides.size(), 1U);
    EXPECT_LE(sides.size(), 2U);
    double area = 0.0;
    for (const ThicknessRegion& side : sides)
    {
      EXPECT_NEAR(side.value, 1.0, 1e-6);
      area += side.area;
    }
    EXPECT_NEAR(area, 64.0, 16.0);
  }
}

// A plate all of which is too thin, edges and narrow sides included.
TEST(ThicknessRegions, AThinPlateIsOneRegion)
{
  const Point3 half{ 1.0, 0.8, 0.05 };
  const TriangleMesh mesh = subdivided(box(half), 4);
  const Regions found = Measured(mesh).thin(0.2);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_NEAR(found[0].area, 8.0 * (0.8 + 0.05 + 0.04), 1e-6);
  EXPECT_NEAR(found[0].value, 0.1, 1e-7);
  EXPECT_EQ(found[0].cells.size(), mesh.triangles.size());
}

// The narrow sides of a wall much thinner than triangles are small, flush with those of a block
// whose own strip reaches there.
TEST(ThicknessRegions, AThinWallOnABlockIsOneRegion)
{
  constexpr double kThin = 0.01;
  const std::string wall = "....#....";
  const std::string base = "#########";
  TriangleMesh mesh = subdivided(blocks({ wall, wall, wall, base, base, base }, 6.0), 2);
  for (Point3& x : mesh.points)
  {
    // Of the columns of blocks, that of the wall is as wide as it is thick.
    x[0] = x[0] <= 3.5 ? x[0] : x[0] >= 4.5 ? x[0] - (1.0 - kThin) : 3.5 + kThin * (x[0] - 3.5);
  }
  const Regions found = Measured(mesh).thin(0.5);
  ASSERT_EQ(found.size(), 1U) << textOf(found);
  EXPECT_NEAR(found[0].value, kThin, 1e-6);
  EXPECT_NEAR(found[0].area, 2 * 36.0 + kThin * (3.0 + 12.0 + 3.0), 0.03);
}

// What a fin stands on has no wall, and is no part of it, whichever way triangles face.
TEST(ThicknessRegions, AFinEndsAtItsFoot)
{
  const TriangleMesh mesh = subdivided(tetrahedronWithFin(), 3);
  for (const TriangleMesh& either : { mesh, flipOrientation(mesh) })
  {
    const Regions found = Measured(either).thin(1.0);
    ASSERT_EQ(found.size(), 1U) << textOf(found);
    EXPECT_NEAR(found[0].value, 0.5, 1e-6);
    EXPECT_NEAR(found[0].area, 2 * 400.0 + 0.5 * 60.0, 1e-3);
  }
}

// The walls of holes are narrow sides of a plate, however coarse the mesh is: the solid opens at
// their corners, but not at their rims.
TEST(ThicknessRegions, AThinPlateWithHolesIsOneRegion)
{
  const TriangleMesh mesh = blocks({ "#####", "#.#.#", "#####" }, 0.05);
  for (const int times : { 0, 1, 2 })
  {
    const Regions found = Measured(subdivided(mesh, times)).thin(0.15);
    ASSERT_EQ(found.size(), 1U) << textOf(found);
    EXPECT_NEAR(found[0].value, 0.1, 1e-6);
    EXPECT_NEAR(found[0].area, 2 * 13.0 + 0.1 * (16.0 + 8.0), 1e-6);
  }
}

// The clearance of a slot 1 wide, 3 deep and 8 long: its sides and its bottom, but not what is
// around its mouth.
TEST(ThicknessRegions, ASlotEndsAtItsMouth)
{
  const std::string walls = "####.####";
  const std::string base = "#########";
  const TriangleMesh mesh = subdivided(blocks({ walls, walls, walls, base, base }, 4.0), 2);
  for (const Side side : { Side::Exterior, Side::Both })
  {
    const Regions found = Measured(mesh, ThicknessMethod::Wall, side).thin(1.5);
    ASSERT_EQ(found.size(), 1U) << textOf(found);
    EXPECT_NEAR(found[0].value, 1.0, 1e-6);
    EXPECT_NEAR(found[0].area, 2 * 24.0 + 8.0, 1e-6);
  }
}

TEST(ThicknessRegions, APlaceIsWhereTheValueIs)
{
  // A gap between plates that is narrowest at x = -1.
  TriangleMesh mesh = subdivided(plates(0.4, 1.0), 3);
  for (Point3& x : mesh.points)
  {
    x[2] *= 1.0 + 0.05 * x[0];
  }
  const Regions found = Measured(mesh, ThicknessMethod::Ball).beyond({ 0.39, 0.41 });
  ASSERT_EQ(found.size(), 4U); // two sides each
  EXPECT_TRUE(found[0].thin);
  EXPECT_TRUE(found[1].thin);
  EXPECT_FALSE(found[2].thin);
  EXPECT_NEAR(found[0].value, 0.38, 0.001);
  EXPECT_NEAR(found[0].place[0], -1.0, 1e-9);
  EXPECT_NEAR(found[2].value, 0.42, 0.001);
  EXPECT_NEAR(found[2].place[0], 1.0, 1e-9);
}

// Their parts would have normals of rounding errors, and lie on those of other edges.
TEST(ThicknessRegions, TrianglesWithoutAreaChangeNothing)
{
  const TriangleMesh plate = box({ 5.0, 3.0, 0.1 });
  const TriangleMesh tilted = translated(turned(turned(plate, 0, 0.7), 2, 1.1), { 70, -30, 9 });
  for (const TriangleMesh& clean : { plate, tilted })
  {
    for (const double height : { 0.0, 1e-14, 1e-11, 1e-6 })
    {
      const TriangleMesh dirty = withFlatTriangles(clean, height > 1e-9 ? 6 : 40, height, 5);
      ASSERT_GT(height > 0.0 ? 1 : dirty.degenerateTriangles, 0);
      for (const ThicknessMethod method : kMethods)
      {
        const bool wall = method == ThicknessMethod::Wall;
        const bool ball = method == ThicknessMethod::Ball;
        const std::string what = "method " + std::to_string(static_cast<int>(method)) +
          ", height " + std::to_string(height);
        const Measured measured(subdivide(dirty, 0.5).mesh, method);
        const Regions thin = measured.thin(0.3);
        ASSERT_EQ(thin.size(), wall ? 1U : 2U) << what << "\n" << textOf(thin);
        double area = 0.0;
        for (const ThicknessRegion& region : thin)
        {
          EXPECT_NEAR(region.value, 0.2, 1e-4) << what;
          area += region.area;
        }
        // Balls are smaller beside edges: these do not count.
        EXPECT_NEAR(area, wall ? 126.4 : (ball ? 115.0 : 120.0), ball ? 4.0 : 1e-2) << what;
        const Regions thick = measured.beyond({ std::nullopt, 0.3 });
        double narrow = 0.0; // sides, along which rays go from end to end
        for (const ThicknessRegion& region : thick)
        {
          narrow += region.area;
        }
        EXPECT_NEAR(narrow, method == ThicknessMethod::Ray ? 6.4 : 0.0, 1e-2) << what << "\n"
                                                                              << textOf(thick);
      }
    }
  }
}

TEST(ThicknessRegions, AThickBlockIsFound)
{
  const Regions found = Measured(ribOnBase()).beyond({ std::nullopt, 2.0 });
  ASSERT_GE(found.size(), 1U);
  EXPECT_FALSE(found[0].thin);
  EXPECT_NEAR(found[0].value, 3.0, 0.2);
}

// Balls beside the edges of a bar touch two sides that meet. It is thick there all the same.
TEST(ThicknessRegions, APlaceBesideAnEdgeCanBeTooThick)
{
  const TriangleMesh mesh = subdivided(box({ 5.0, 5.0, 20.0 }), 4);
  for (const ThicknessMethod method : kMethods)
  {
    const Regions found = Measured(mesh, method).beyond({ std::nullopt, 5.0 });
    ASSERT_FALSE(found.empty()) << static_cast<int>(method);
    EXPECT_FALSE(found[0].thin);
    EXPECT_NEAR(found[0].value, method == ThicknessMethod::Ray ? 40.0 : 10.0, 0.5);
  }
  double area = 0.0;
  for (const ThicknessRegion& region :
    Measured(mesh, ThicknessMethod::Ball).beyond({ std::nullopt, 5.0 }))
  {
    area += region.area;
  }
  // The diameter is twice the distance from the nearest edge.
  EXPECT_NEAR(area, 4 * 5.0 * 35.0 + 2 * 25.0, 50.0);
}

TEST(ThicknessRegions, LimitsAtTheValueAreKept)
{
  const TriangleMesh mesh = subdivided(plates(0.1, 1.0), 2);
  EXPECT_TRUE(Measured(mesh, ThicknessMethod::Ball).beyond({ 0.1, 0.1000001 }).empty());
  EXPECT_TRUE(Measured(mesh, ThicknessMethod::Ray).beyond({ std::nullopt, 0.1 }).empty());
}

TEST(ThicknessRegions, TrianglesThatShareAPointAreOneRegion)
{
  const TriangleMesh fan = makeMesh({ { 0, 0, 0 }, { 1, -1, 0 }, { 1, 1, 0 }, { -1, 1, 0 },
                                      { -1, -1, 0 }, { 5, 0, 0 }, { 6, 0, 0 }, { 5, 1, 0 } },
    { { 0, 1, 2 }, { 0, 2, 3 }, { 0, 3, 4 }, { 0, 4, 1 }, { 5, 6, 7 } });
  Thickness thickness;
  thickness.values.assign(fan.points.size(), 2.0F);
  thickness.atEdge.assign(fan.points.size(), 0);
  thickness.triangleValues = { 0.5F, 2.0F, 0.4F, 2.0F, 0.3F };
  thickness.triangleAtEdge.assign(5, 0);
  const Regions regions = findThicknessRegions(fan, thickness, { 1.0, std::nullopt });
  ASSERT_EQ(regions.size(), 2U);
  EXPECT_EQ(regions[0].triangles, (std::vector<int>{ 4 }));
  EXPECT_EQ(regions[1].triangles, (std::vector<int>{ 0, 2 }));
  EXPECT_NEAR(regions[1].value, 0.4, 1e-6);
  // Too thin and too thick places are different regions even there.
  thickness.triangleValues[2] = 9.0F;
  EXPECT_EQ(findThicknessRegions(fan, thickness, { 1.0, 5.0 }).size(), 3U);
}

TEST(ThicknessRegions, RefusesWhatIsOutsideItsRange)
{
  expectRefused({ 2.0, 1.0 }, "minimum thickness 2 is not below maximum thickness 1");
  expectRefused({ 1.0, 1.0 }, "not below");
  expectRefused({ 0.0, {} }, "minimum thickness 0 is outside (0, infinity)");
  expectRefused({ {}, -1.0 }, "maximum thickness -1");
  expectRefused({ std::nan(""), {} }, "outside");
  expectRefused({}, "neither");
  const TriangleMesh mesh = box({ 1.0, 1.0, 1.0 });
  const MeshConnectivity connectivity = analyseConnectivity(mesh);
  EXPECT_THROW(findThicknessRegions(mesh, computeThickness(mesh), { 0.1, {} }), Error);
}

TEST(ThicknessRegions, OneSideOfAnOpenMeshIsNoSolid)
{
  const auto require = [](const TriangleMesh& mesh)
  { requireInside(mesh, analyseConnectivity(mesh)); };
  EXPECT_NO_THROW(require(box({ 1.0, 1.0, 1.0 })));
  EXPECT_NO_THROW(require(openTube(0.1, 4.0, 32))); // a vessel
  EXPECT_THROW(require(plates(0.1, 1.0)), Error);
  EXPECT_THROW(require(makeMesh({ { 0, 0, 0 }, { 1, 0, 0 } }, {}, { { 0, 1 } })), Error);
}
