// Grids that are far from their mesh, very flat or very large, where single precision is coarse.
#include "medial/compute_distance_field.h"
#include "medial/compute_medial_axis.h"
#include "medial/error.h"

#include "support/brute_force.h"
#include "support/errors.h"
#include "support/field_checks.h"
#include "support/named.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <random>
#include <string>
#include <vector>

using namespace medial;
using namespace medial::test;

namespace
{

TriangleMesh ring()
{
  return torus(1.0, 0.4, 32, 16);
}

TriangleMesh onePoint()
{
  return makeMesh({ { 0.1, 77.7, -1234.5 } }, {}, {}, { 0 });
}

Grid flatGrid(double ratio)
{
  return { { -1.5, -1.5, -0.6 }, { 0.1, 0.1, 0.1 / ratio }, { 31, 31, 12 } };
}

/// A small grid on the diagonal, so many voxels from the origin.
Grid farGrid(double voxels)
{
  return { { 0.05 * voxels, 0.03 * voxels, -0.02 * voxels }, { 0.05, 0.05, 0.05 }, { 9, 17, 10 } };
}

std::vector<Named<MeshOnGrid>> farGrids()
{
  std::vector<Named<MeshOnGrid>> grids{
    { "flatAroundAPoint",
      [] {
        return MeshOnGrid{ onePoint(), { { -4.0, -4e4, -4e4 }, { 1.0, 1e4, 1e4 }, { 9, 40, 40 } } };
      } },
    { "longAroundAPoint",
      [] {
        return MeshOnGrid{ onePoint(), { { -4.0, -4.0, -4e9 }, { 1.0, 1.0, 1e9 }, { 9, 9, 40 } } };
      } }
  };
  for (const char* size : { "1e3", "1e5", "1e6", "1e12" })
  {
    grids.push_back({ std::string("flat") + size, [size] {
                       return MeshOnGrid{ ring(), flatGrid(std::stod(size)) };
                     } });
  }
  for (const char* size : { "1e5", "1e7", "1e12", "1e17" })
  {
    grids.push_back({ std::string("far") + size, [size] {
                       return MeshOnGrid{ ring(), farGrid(std::stod(size)) };
                     } });
  }
  return grids;
}

DistanceField fieldOf(const TriangleMesh& mesh, const Grid& grid, Engine engine = Engine::Processor)
{
  DistanceFieldOptions options;
  options.engine = engine;
  return computeDistanceField(mesh, grid, options);
}

/// The message with which a field is refused; empty if it is not.
std::string refusalOf(const TriangleMesh& mesh, const Grid& grid, Engine engine = Engine::Processor)
{
  return messageOf([&] { fieldOf(mesh, grid, engine); });
}

void expectExactButForRounding(const TriangleMesh& mesh, const Grid& grid)
{
  const DistanceField field = fieldOf(mesh, grid);
  const std::vector<Hit> truth = closestOnMesh(mesh, gridPoints(grid));
  const MeshConnectivity connectivity = analyseConnectivity(mesh);
  for (std::size_t i = 0; i < truth.size(); ++i)
  {
    const double exact = truth[i].distance;
    const double rounding = std::abs(exact - static_cast<double>(static_cast<float>(exact)));
    const double distance = std::abs(static_cast<double>(field.distance[i]));
    ASSERT_NEAR(distance, exact, 1.001 * rounding + 1e-3 * voxelSize(grid)) << i;
    ASSERT_GE(field.closestSite[i], 0) << i;
    ASSERT_NEAR(distanceToSite(mesh, connectivity, field.closestSite[i], voxelPoint(grid, i)),
      exact, 1e-15 * exact + 1e-3 * voxelSize(grid))
      << i;
  }
}

class FarField : public testing::TestWithParam<Named<MeshOnGrid>>
{
};

} // namespace

/// Nothing is lost but what a distance in single precision cannot hold.
TEST_P(FarField, IsExactButForRounding)
{
  const auto [mesh, grid] = GetParam().make();
  expectExactButForRounding(mesh, grid);
}

INSTANTIATE_TEST_SUITE_P(Grids, FarField, testing::ValuesIn(farGrids()), kNameOfParameter);

TEST(FarField, OfEnginesInSinglePrecisionIsExactOrRefused)
{
  for (const Engine engine : { Engine::Rasteriser, Engine::Device })
  {
    EXPECT_EQ(refusalOf(ring(), flatGrid(100.0), engine), "");
    const Grid flat = flatGrid(1e3);
    const FieldErrors errors = fieldErrors(ring(), fieldOf(ring(), flat, engine), allVoxels(flat));
    EXPECT_LE(errors.distance, 1e-2);
    EXPECT_EQ(errors.withoutSite, 0u);
    for (const Grid& grid : { flatGrid(1e5), farGrid(1e5), farGrid(1e7), farGrid(1e17) })
    {
      EXPECT_NE(refusalOf(ring(), grid, engine).find("more than 32768"), std::string::npos);
    }
  }
}

TEST(FarField, IsRefusedWhereSquaresDoNotFitSinglePrecision)
{
  const Grid away{ { 3e19, 0.0, 0.0 }, { 1.0, 1.0, 1.0 }, { 8, 8, 8 } };
  EXPECT_EQ(refusalOf(ring(), away),
    "the mesh reaches 3e+19 times the finest spacing from the middle of the grid, more than 1e+18");
  EXPECT_NE(refusalOf(ring(), away, Engine::Rasteriser), "");
  EXPECT_EQ(refusalOf(ring(), flatGrid(1e20)),
    "the grid reaches 2.12132e+21 times the finest spacing from the middle of the grid, more than "
    "1e+18");
  EXPECT_NE(refusalOf(ring(), { { 0.0, 0.0, 0.0 }, { 1e-300, 1e300, 1.0 }, { 8, 8, 8 } }), "");
  EXPECT_THROW(computeMedialAxis(ring(), away), Error);
}

/// Grids at random places and with random spacings, over many orders of magnitude.
TEST(FarField, HasASiteAtEveryPointOfAnyGrid)
{
  std::mt19937 random(5);
  const auto power = [&](double low, double high)
  {
    const double share = static_cast<double>(random()) / 4294967296.0;
    return std::pow(10.0, low + share * (high - low));
  };
  int computed = 0;
  for (int i = 0; i < 200; ++i)
  {
    const double size = power(-6.0, 6.0);
    const TriangleMesh mesh =
      scaled(i % 2 == 0 ? regularTetrahedron(1.0) : randomSoup(20, 7), size);
    Grid grid{ {}, {}, { 9, 10, 17 } };
    for (int axis = 0; axis < 3; ++axis)
    {
      grid.origin[axis] = size * power(-3.0, 20.0);
      grid.spacing[axis] = size * power(-8.0, 8.0);
    }
    if (refusalOf(mesh, grid).empty())
    {
      ++computed;
      for (const std::int32_t site : fieldOf(mesh, grid).closestSite)
      {
        ASSERT_GE(site, 0) << i;
      }
    }
  }
  EXPECT_GE(computed, 50);
  EXPECT_LE(computed, 199);
}
