// Local thickness of solids whose balls are known, and of others by branch and bound.
#include "medial/local_thickness.h"

#include "support/brute_force.h"
#include "support/local_thickness_oracle.h"
#include "support/named.h"
#include "support/shapes.h"
#include "support/transforms.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <random>
#include <utility>
#include <vector>

using namespace medial;
using namespace medial::test;

namespace
{

constexpr double kTolerance = 0.1; ///< voxels
/// By how much balls may contain or miss a point in the truth, voxels.
constexpr double kSlack = 0.02;
constexpr double kSearchTolerance = 0.1;

LocalThicknessOptions optionsFor(Side side)
{
  LocalThicknessOptions options;
  options.side = side;
  return options;
}

Point3 pointOf(const Grid& grid, std::size_t id)
{
  const auto x = static_cast<std::size_t>(grid.dimensions[0]);
  const auto y = static_cast<std::size_t>(grid.dimensions[1]);
  return grid.point(static_cast<int>(id % x), static_cast<int>(id / x % y),
    static_cast<int>(id / x / y));
}

Bounds boundsOf(const Grid& grid)
{
  return { grid.origin,
    grid.point(grid.dimensions[0] - 1, grid.dimensions[1] - 1, grid.dimensions[2] - 1) };
}

bool within(const Bounds& bounds, const Point3& p)
{
  bool inside = true;
  for (int axis = 0; axis < 3; ++axis)
  {
    inside = inside && p[axis] > bounds.min[axis] && p[axis] < bounds.max[axis];
  }
  return inside;
}

std::vector<std::size_t> randomPointsWithValue(const LocalThickness& thickness, const Bounds& part,
  std::size_t count)
{
  std::vector<std::size_t> ids;
  for (std::size_t i = 0; i < thickness.values.size(); ++i)
  {
    if (thickness.values[i] != 0.0f && within(part, pointOf(thickness.grid, i)))
    {
      ids.push_back(i);
    }
  }
  std::mt19937 random(5);
  std::shuffle(ids.begin(), ids.end(), random);
  ids.resize(std::min(ids.size(), count));
  return ids;
}

std::vector<DiameterBounds> truthAt(const TriangleMesh& mesh, const Grid& grid,
  const std::vector<std::size_t>& ids)
{
  const double voxel = grid.spacing[0];
  const MeshSearch search(mesh);
  std::vector<DiameterBounds> truth(ids.size());
  parallelFor(ids.size(),
    [&](std::size_t i)
    {
      truth[i] = largestBallAround(search, boundsOf(grid), pointOf(grid, ids[i]), kSlack * voxel,
        kSearchTolerance * voxel);
    });
  return truth;
}

void expectTruthAt(const std::vector<std::size_t>& ids, const TriangleMesh& mesh,
  const LocalThickness& thickness)
{
  const double voxel = thickness.grid.spacing[0];
  const std::vector<DiameterBounds> truth = truthAt(mesh, thickness.grid, ids);
  for (std::size_t i = 0; i < ids.size(); ++i)
  {
    const double value = std::fabs(static_cast<double>(thickness.values[ids[i]]));
    EXPECT_LE((value - truth[i].max) / voxel, kTolerance) << "point " << ids[i];
    EXPECT_LE((truth[i].min - value) / voxel, kTolerance) << "point " << ids[i];
  }
}

/// @param part the points that are looked at.
void expectTruth(const TriangleMesh& mesh, Side side, int resolution, const Bounds& part)
{
  const Grid grid = makeGrid(mesh.bounds(), resolution, 0.05);
  const LocalThickness thickness = computeLocalThickness(mesh, grid, optionsFor(side));
  const std::vector<std::size_t> ids = randomPointsWithValue(thickness, part, 40);
  ASSERT_EQ(ids.size(), 40u);
  expectTruthAt(ids, mesh, thickness);
}

/// Calls check(point, value) for all grid points with a value.
template <typename Check>
void forValues(const LocalThickness& thickness, const Check& check)
{
  std::size_t count = 0;
  for (std::size_t i = 0; i < thickness.values.size(); ++i)
  {
    if (thickness.values[i] != 0.0f)
    {
      check(pointOf(thickness.grid, i), static_cast<double>(thickness.values[i]));
      ++count;
    }
  }
  EXPECT_GT(count, 100u);
}

/// Returns the largest radius up to a limit for which a condition holds: it does for all smaller
/// ones.
template <typename Condition>
double largestRadius(double limit, const Condition& holds)
{
  if (holds(limit))
  {
    return limit;
  }
  double low = 0.0;
  double high = limit;
  for (int i = 0; i < 50; ++i)
  {
    const double middle = 0.5 * (low + high);
    (holds(middle) ? low : high) = middle;
  }
  return low;
}

/// Diameter of the largest ball around a point of a box: where balls of a radius fit, their centres
/// fill a smaller box, which is nearer to the point than the radius only up to the largest one.
double largestBallInBox(const Point3& half, const Point3& point)
{
  return 2.0 *
    largestRadius(*std::min_element(half.begin(), half.end()),
      [&](double radius)
      {
        double squared = 0.0;
        for (int axis = 0; axis < 3; ++axis)
        {
          const double outside = std::fabs(point[axis]) - (half[axis] - radius);
          squared += outside > 0.0 ? outside * outside : 0.0;
        }
        return squared <= radius * radius;
      });
}

/// Diameter of the largest ball around a point of a cylinder, likewise.
/// @param across, along how far the point is from the axis and from the middle.
double largestBallInCylinder(double radius, double half, double across, double along)
{
  return 2.0 *
    largestRadius(std::min(radius, half),
      [&](double ball)
      {
        return std::hypot(std::max(across - (radius - ball), 0.0),
                 std::max(along - (half - ball), 0.0)) <= ball;
      });
}

/// @param half half the edges of a box around the origin; only the points in it count.
void expectBallsOfBox(const LocalThickness& thickness, const Point3& half)
{
  const double voxel = thickness.grid.spacing[0];
  std::size_t count = 0;
  for (std::size_t i = 0; i < thickness.values.size(); ++i)
  {
    const Point3 p = pointOf(thickness.grid, i);
    if (within({ { -half[0], -half[1], -half[2] }, half }, p))
    {
      const double value = std::fabs(static_cast<double>(thickness.values[i]));
      EXPECT_NEAR(value / voxel, largestBallInBox(half, p) / voxel, kTolerance)
        << "at " << p[0] << ' ' << p[1] << ' ' << p[2];
      ++count;
    }
  }
  EXPECT_GT(count, 1000u);
}

class LocalThicknessOf : public testing::TestWithParam<Named<TriangleMesh>>
{
};

/// Three rods across three others.
TriangleMesh lattice()
{
  return blocks({ "#####", "#.#.#", "#####", "#.#.#", "#####" }, 0.5);
}

} // namespace

TEST_P(LocalThicknessOf, IsTheLargestBallAroundEveryPoint)
{
  const TriangleMesh mesh = GetParam().make();
  expectTruth(mesh, Side::Interior, 26, mesh.bounds());
}

INSTANTIATE_TEST_SUITE_P(Solids, LocalThicknessOf,
  testing::Values(Named<TriangleMesh>{ "Box",
                    [] {
                      return box({ 1.0, 0.7, 0.4 });
                    } },
    Named<TriangleMesh>{ "TurnedBox",
      [] {
        return turned(turned(box({ 1.0, 0.7, 0.4 }), 2, 37.0), 0, 16.0);
      } },
    Named<TriangleMesh>{ "LatticeOfRods", lattice }),
  kNameOfParameter);

TEST(LocalThickness, OfABentBoxIsTheLargestBallAroundEveryPoint)
{
  const TriangleMesh mesh = lPrism(1.0, 0.5);
  expectTruth(mesh, Side::Interior, 25, mesh.bounds());
}

// Points between the facets of its end are in no ball with an angle of 25 degrees.
TEST(LocalThickness, OfTheEndOfAnEllipsoidIsNotLargerThanTheTruth)
{
  const TriangleMesh mesh = ellipsoid(1.0, 0.7, 0.4, 4);
  const Grid grid = makeGrid(mesh.bounds(), 48, 0.05);
  const LocalThickness thickness = computeLocalThickness(mesh, grid);
  const std::vector<std::size_t> ids =
    randomPointsWithValue(thickness, { { 0.0, -0.7, 0.0 }, { 0.1, -0.69, 0.1 } }, 5);
  ASSERT_EQ(ids.size(), 2u);
  const std::vector<DiameterBounds> truth = truthAt(mesh, grid, ids);
  for (std::size_t i = 0; i < ids.size(); ++i)
  {
    const double value = static_cast<double>(thickness.values[ids[i]]);
    EXPECT_LE((value - truth[i].max) / grid.spacing[0], kTolerance) << "point " << ids[i];
    EXPECT_GT(value / grid.spacing[0], 9.0);
  }
}

// The largest balls there have angles below 25 degrees.
TEST(LocalThickness, AtTheSurfaceOfAnEllipsoidIsTheLargestBallAroundEveryPoint)
{
  const TriangleMesh mesh = ellipsoid(1.0, 0.7, 0.4, 4);
  const Grid grid = makeGrid(mesh.bounds(), 48, 0.05);
  const LocalThickness thickness = computeLocalThickness(mesh, grid);
  const std::vector<std::size_t> ids =
    randomPointsWithValue(thickness, { { -0.37, -0.66, -0.08 }, { -0.3, -0.64, 0.0 } }, 3);
  EXPECT_GT(ids.size(), 1u);
  expectTruthAt(ids, mesh, thickness);
}

// Sheets with small radii of curvature meet in a tip there. Where balls of a radius fit, their
// centres fill a smaller cylinder.
TEST(LocalThickness, OfACylinderWithFlatEndsIsTheLargestBallAroundEveryPoint)
{
  constexpr double kRadius = 0.4;
  constexpr double kHalf = 1.0;
  constexpr int kFacets = 48;
  const TriangleMesh mesh = cylinder(kRadius, 2.0 * kHalf, kFacets);
  const Grid grid = makeGrid(mesh.bounds(), 48, 0.05);
  const double voxel = grid.spacing[0];
  const double inner = kRadius * std::cos(std::acos(-1.0) / kFacets);
  forValues(computeLocalThickness(mesh, grid),
    [&](const Point3& p, double value)
    {
      const double across = std::hypot(p[0], p[1]);
      const double depth = std::min(inner - across, kHalf - std::fabs(p[2]));
      if (depth > 0.25 * voxel) // nearer, the facets matter
      {
        const auto truth = [&](double radius)
        { return largestBallInCylinder(radius, kHalf, across, std::fabs(p[2])); };
        EXPECT_LE((value - truth(kRadius)) / voxel, kTolerance);
        EXPECT_LE((truth(inner) - value) / voxel, 0.2) << p[0] << ' ' << p[1] << ' ' << p[2];
      }
    });
}

TEST(LocalThickness, OfTipsThinnerThanTheSpacingIsTheLargestBallAroundEveryPoint)
{
  expectTruth(regularTetrahedron(1.0), Side::Interior, 48,
    { { 0.26, 0.26, 0.26 }, { 0.36, 0.36, 0.36 } });
}

TEST(LocalThickness, OfBoxesIsTheLargestBallAroundEveryPoint)
{
  for (const auto& [half, resolution] : { std::pair{ Point3{ 1.0, 0.7, 0.4 }, 26 },
         std::pair{ Point3{ 0.5, 0.4, 0.3 }, 31 }, std::pair{ Point3{ 1.0, 0.15, 0.15 }, 60 },
         std::pair{ Point3{ 0.8, 0.6, 0.4 }, 28 }, std::pair{ Point3{ 0.8, 0.6, 0.4 }, 33 } })
  {
    const TriangleMesh mesh = box(half);
    const Grid grid = makeGrid(mesh.bounds(), resolution, 0.05);
    expectBallsOfBox(computeLocalThickness(mesh, grid), half);
  }
}

TEST(LocalThickness, SeparationInABoxIsTheLargestBallAroundEveryPoint)
{
  const Point3 half{ 0.8, 0.6, 0.4 };
  const TriangleMesh mesh = appended(box({ 1.0, 0.8, 0.7 }), flipOrientation(box(half)));
  for (const int resolution : { 28, 37 })
  {
    const Grid grid = makeGrid(mesh.bounds(), resolution, 0.05);
    expectBallsOfBox(computeLocalThickness(mesh, grid, optionsFor(Side::Exterior)), half);
  }
}

TEST(LocalThickness, OfATubeIsItsDiameter)
{
  // Its axis is a curve, and facets make it one of many short sheets.
  const TriangleMesh mesh = torus(1.0, 0.4, 96, 48);
  const Grid grid = makeGrid(mesh.bounds(), 48, 0.05);
  const LocalThickness thickness = computeLocalThickness(mesh, grid);
  forValues(thickness,
    [&](const Point3& p, double value)
    {
      if (std::hypot(std::hypot(p[0], p[1]) - 1.0, p[2]) < 0.38)
      {
        EXPECT_NEAR(value, 0.8, 0.1 * grid.spacing[0]) << p[0] << ' ' << p[1] << ' ' << p[2];
      }
    });
}

TEST(LocalThickness, OfABallIsItsDiameter)
{
  const TriangleMesh mesh = icosphere(1.0, 4);
  const LocalThickness thickness = computeLocalThickness(mesh, makeGrid(mesh.bounds(), 40, 0.05));
  std::size_t points = 0;
  forValues(thickness,
    [&](const Point3& p, double value)
    {
      if (std::hypot(p[0], p[1], p[2]) < 0.99) // facets are up to 0.002 from the ball
      {
        EXPECT_NEAR(value, 2.0, 0.015) << p[0] << " " << p[1] << " " << p[2];
        ++points;
      }
    });
  EXPECT_GT(points, 15000u);
}

TEST(LocalThickness, OfAPlateIsItsThicknessAwayFromTheRim)
{
  const TriangleMesh mesh = box({ 1.0, 1.0, 0.15 });
  const Grid grid = makeGrid(mesh.bounds(), 64, 0.05);
  const LocalThickness thickness = computeLocalThickness(mesh, grid);
  forValues(thickness,
    [&](const Point3& p, double value)
    {
      if (std::max(std::fabs(p[0]), std::fabs(p[1])) < 0.85)
      {
        EXPECT_NEAR(value, 0.3, grid.spacing[0] / 128) << p[0] << ' ' << p[1] << ' ' << p[2];
      }
    });
}

TEST(LocalThickness, OfAShellIsItsWallAndSeparationItsHollow)
{
  const TriangleMesh mesh = shell(0.7, 1.0, 5);
  const Grid grid = makeGrid(mesh.bounds(), 56, 0.05);
  LocalThickness thickness = computeLocalThickness(mesh, grid, optionsFor(Side::Both));
  forValues(thickness,
    [&](const Point3& p, double value)
    {
      const double r = std::hypot(p[0], p[1], p[2]);
      if (r > 0.72 && r < 0.98)
      {
        EXPECT_NEAR(value, 0.3, 0.1 * grid.spacing[0]);
      }
      else if (r < 0.68)
      {
        EXPECT_NEAR(value, -1.4, 0.1 * grid.spacing[0]);
      }
    });
}

TEST(LocalThickness, OfPointsBarelyInsideIsNotZero)
{
  const TriangleMesh mesh = box({ 1.0, 1.0, 1.0 });
  Grid grid;
  grid.origin = { -0.99999, -0.99999, -0.99999 };
  grid.spacing = { 0.125, 0.125, 0.125 };
  grid.dimensions = { 8, 8, 8 };
  const LocalThickness thickness = computeLocalThickness(mesh, grid);
  EXPECT_EQ(thickness.statistics.thickness->points, grid.pointCount());
  EXPECT_GT(thickness.statistics.thickness->min, 0.0);
}

TEST(LocalThickness, OfAPlateOnAGridOfUnevenSpacing)
{
  const TriangleMesh mesh = box({ 1.0, 1.0, 0.15 });
  const Grid grid = makeGridWithSpacing(mesh.bounds(), { 0.05, 0.1, 0.03 }, 0.05);
  const LocalThickness thickness = computeLocalThickness(mesh, grid);
  forValues(thickness,
    [&](const Point3& p, double value)
    {
      if (std::max(std::fabs(p[0]), std::fabs(p[1])) < 0.8)
      {
        EXPECT_NEAR(value, 0.3, 0.1 * 0.03) << p[0] << ' ' << p[1] << ' ' << p[2];
      }
    });
}
