#include "medial/compute_distance_field.h"
#include "medial/compute_medial_axis.h"

#include "support/brute_force.h"
#include "support/field_checks.h"
#include "support/medial_checks.h"
#include "support/model_formats.h"
#include "support/models.h"
#include "support/named.h"
#include "support/printing.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

using namespace medial;
using namespace medial::test;

namespace
{

struct AxisCase
{
  TriangleMesh mesh;
  Grid grid;
  Side side;
};

AxisCase around(const TriangleMesh& mesh, Side side, int resolution = 40)
{
  return { mesh, makeGrid(mesh.bounds(), resolution, 0.15), side };
}

/// Grids that cut through the axis, so that it ends at their borders.
Grid cutGrid(const Point3& spacing, const std::array<int, 3>& dimensions)
{
  return { { -0.31, -0.33, -0.37 }, spacing, dimensions };
}

std::vector<Named<AxisCase>> cases()
{
  const auto solid = [](const Grid& grid) {
    return AxisCase{ box({ 1.1, 0.8, 0.5 }), grid, Side::Both };
  };
  static const Point3 h{ 0.057, 0.057, 0.057 };
  std::vector<Named<AxisCase>> result{ { "soup",
                                         [] { return around(randomSoup(40, 6), Side::Both); } },
    { "lPrism", [] { return around(lPrism(1.0, 0.6), Side::Both); } },
    { "hair",
      []
      {
        return around(appended(hair(0.5, 6), translated(plates(0.1, 0.5), { 0.0, 0.1, 0.4 })),
          Side::Both);
      } },
    { "thinEllipsoid", [] { return around(ellipsoid(1.0, 0.7, 0.05, 3), Side::Interior); } },
    { "farAway",
      [] {
        return around(translated(torus(0.5, 0.2, 24, 12), { 1e4, -2e4, 3e4 }), Side::Interior);
      } },
    { "tiny", [] { return around(scaled(torus(0.5, 0.2, 24, 12), 1e-6), Side::Interior); } },
    { "insideTheSolid",
      [=] {
        return solid(cutGrid(h, { 14, 12, 11 }));
      } },
    { "unequalSpacing",
      [=] {
        return solid(cutGrid({ 0.031, 0.057, 0.093 }, { 60, 17, 9 }));
      } },
    { "oneSlice",
      [=] {
        return solid({ { -1.02, -0.77, -0.21 }, h, { 36, 27, 1 } });
      } },
    { "oneRow",
      [=] {
        return solid({ { -1.02, 0.11, -0.21 }, h, { 36, 1, 1 } });
      } },
    { "points",
      []
      {
        return AxisCase{ makeMesh({ { 0.0, 0.0, 0.0 }, { 1.0, 0.2, 0.1 }, { 0.3, 0.9, 0.2 } }, {},
                           {}, { 0, 1, 2 }),
          cutGrid({ 0.083, 0.083, 0.083 }, { 18, 19, 9 }), Side::Both };
      } } };
  for (const auto& [name, file] : std::vector<std::pair<const char*, const char*>>{
         { "triceratops", "paper/triceratops.off" }, { "beetle", "soup/beetle_vw_2k.obj" } })
  {
    if (const auto path = modelPath(file))
    {
      result.push_back({ name, [path] { return around(loadMesh(*path), Side::Both, 80); } });
    }
  }
  return result;
}

MedialAxis compute(const AxisCase& input, Representation representation,
  const DistanceFieldOptions& field = {})
{
  MedialAxisOptions options;
  options.side = input.side;
  options.representation = representation;
  options.field = field;
  return computeMedialAxis(input.mesh, input.grid, options);
}

/// The maximum distance of every twentieth point of `a` from the points of `b`.
double farthest(const MedialAxis& a, const MedialAxis& b)
{
  std::vector<Point3> some;
  for (std::size_t i = 0; i < a.points.size(); i += 20)
  {
    some.push_back(a.points[i]);
  }
  const std::vector<double> distances = distancesToPoints(some, b.points);
  return distances.empty() ? 0.0 : *std::max_element(distances.begin(), distances.end());
}

class MedialAxisContract : public testing::TestWithParam<Named<AxisCase>>
{
protected:
  /// Sheets need grid cells, and a grid of one slice has none.
  static void expectContract(Representation representation)
  {
    const AxisCase input = GetParam().make();
    for (const DistanceFieldOptions& options : allEngines())
    {
      SCOPED_TRACE(options.engine);
      const MedialAxis axis = compute(input, representation, options);
      if (input.grid.dimensions[2] == 1)
      {
        EXPECT_EQ(axis.points.size(), 0u);
        EXPECT_EQ(axis.cellCount(), 0);
        continue;
      }
      expectConsistent(input.mesh, input.grid, axis, representation);
    }
  }
};

} // namespace

TEST_P(MedialAxisContract, HoldsForSurfaces)
{
  expectContract(Representation::Surface);
}

TEST_P(MedialAxisContract, HoldsForVoxelFaces)
{
  expectContract(Representation::Faces);
}

TEST_P(MedialAxisContract, HoldsForPoints)
{
  const AxisCase input = GetParam().make();
  const MedialAxis axis = compute(input, Representation::Points);
  expectConsistent(input.mesh, input.grid, axis, Representation::Points);
  EXPECT_EQ(axis.vertices.size(), axis.points.size());
}

INSTANTIATE_TEST_SUITE_P(Cases, MedialAxisContract, testing::ValuesIn(cases()), kNameOfParameter);

TEST(MedialAxis, IsTheSameForAnyMemoryLimitAndThreads)
{
  const TriangleMesh mesh = lPrism(1.0, 0.6);
  const AxisCase input{ mesh, offCentreGrid(mesh, 0.0213), Side::Interior };
  for (const Representation representation : { Representation::Surface, Representation::Points })
  {
    DistanceFieldOptions options;
    options.execution.threads = 1;
    options.memoryMiB = 64;
    const MedialAxis expected = compute(input, representation);
    const MedialAxis axis = compute(input, representation, options);
    EXPECT_EQ(axis.points.size(), expected.points.size());
    EXPECT_EQ(axis.cellCount(), expected.cellCount());
    EXPECT_LE(farthest(axis, expected), 1e-3 * input.grid.spacing[0]);
    EXPECT_LE(farthest(expected, axis), 1e-3 * input.grid.spacing[0]);
  }
}

TEST(MedialAxis, IsTheSameByAllEngines)
{
  const TriangleMesh mesh = lPrism(1.0, 0.6);
  const AxisCase input{ mesh, offCentreGrid(mesh, 0.0213), Side::Both };
  const std::vector<DistanceFieldOptions> engines = allEngines();
  const MedialAxis expected = compute(input, Representation::Surface, engines.back());
  for (std::size_t i = 0; i + 1 < engines.size(); ++i)
  {
    const MedialAxis axis = compute(input, Representation::Surface, engines[i]);
    ASSERT_GT(axis.points.size(), 1000u);
    EXPECT_EQ(axis.points.size(), expected.points.size());
    EXPECT_EQ(axis.cellCount(), expected.cellCount());
    EXPECT_LE(farthest(axis, expected), 1e-3 * input.grid.spacing[0]);
    EXPECT_LE(farthest(expected, axis), 1e-3 * input.grid.spacing[0]);
  }
}

TEST(MedialAxis, LeavesTheDistanceFieldAsWell)
{
  const TriangleMesh mesh = torus(1.0, 0.4, 24, 12);
  const Grid grid = makeGrid(mesh.bounds(), 48, 0.1);
  const DistanceField field = computeDistanceField(mesh, grid);
  for (const DistanceFieldOptions& each : allEngines())
  {
    DistanceField left;
    left.grid = grid;
    left.distance.resize(field.distance.size());
    left.closestSite.resize(field.closestSite.size());
    FieldArrays arrays;
    arrays.distance = left.distance.data();
    arrays.closestSite = left.closestSite.data();
    MedialAxisOptions options;
    options.field = each;
    computeMedialAxis(mesh, analyseConnectivity(mesh), grid, options, arrays);
    const FieldDifference change = difference(mesh, field, left);
    EXPECT_LT(change.distance, 1e-3);
    EXPECT_EQ(change.untiedSites, 0u);
  }
}

TEST(MedialAxis, OfTheInteriorIsInside)
{
  const TriangleMesh mesh = flipOrientation(lPrism(1.0, 0.6));
  const AxisCase input = around(mesh, Side::Interior);
  for (const Representation representation : { Representation::Surface, Representation::Points })
  {
    const MedialAxis axis = compute(input, representation);
    EXPECT_EQ(axis.side, Side::Interior);
    EXPECT_EQ(axis.sign, SignMethod::Winding);
    for (const Point3& point : axis.points)
    {
      EXPECT_GT(std::abs(windingNumber(mesh, point)), 0.5);
    }
  }
}
