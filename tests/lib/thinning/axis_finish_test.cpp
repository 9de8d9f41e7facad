#include "medial/axis_curves.h"
#include "medial/compute_medial_axis.h"
#include "thinning/sound_cells.h"

#include "support/axes.h"
#include "support/border_roughness.h"
#include "support/bordered_shapes.h"
#include "support/medial_checks.h"
#include "support/medial_truth.h"
#include "support/point_math.h"
#include "support/shapes.h"
#include "support/tubes.h"
#include "support/voxel_topology.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

using namespace medial;
using namespace medial::test;

namespace
{

MedialAxisOptions preserving(double angle = 60.0)
{
  MedialAxisOptions options;
  options.angle = angle;
  options.topology = Topology::Preserve;
  return options;
}

MedialAxis preserved(const TriangleMesh& mesh, double spacing, double angle = 60.0)
{
  return computeMedialAxis(mesh, offCentreGrid(mesh, spacing), preserving(angle));
}

double relativeError(const MedialAxis& axis, double area)
{
  return std::abs(areaOf(axis) / area - 1.0);
}

void expectTopologyOfSolid(const MedialAxis& axis)
{
  ASSERT_TRUE(axis.solid.has_value());
  EXPECT_EQ(topologyOf(axis), *axis.solid);
  const CellTopology counted = countedTopology(axis);
  EXPECT_EQ(counted.components, axis.solid->components);
  EXPECT_EQ(counted.eulerCharacteristic, axis.solid->eulerCharacteristic);
}

/// The only curve of an axis without sheets, as places.
std::vector<Point3> onlyCurve(const MedialAxis& axis)
{
  EXPECT_TRUE(axis.quads.empty());
  const std::vector<AxisCurve> curves = axisCurves(edgesOf(axis), axis.points.size());
  EXPECT_EQ(curves.size(), 1u);
  std::vector<Point3> places;
  for (const std::int64_t point : curves.front().points)
  {
    places.push_back(axis.points[point]);
  }
  return places;
}

/// Tubes with rounded ends along a direction.
TriangleMesh alongDirection(const TriangleMesh& tube, const Point3& direction)
{
  const double length = std::hypot(direction[0], direction[1], direction[2]);
  const double polar = std::acos(direction[2] / length);
  const double azimuth = std::atan2(direction[1], direction[0]);
  TriangleMesh turned = tube;
  for (Point3& p : turned.points)
  {
    const Point3 q{ std::cos(polar) * p[0] + std::sin(polar) * p[2], p[1],
      std::cos(polar) * p[2] - std::sin(polar) * p[0] };
    p = { std::cos(azimuth) * q[0] - std::sin(azimuth) * q[1],
      std::sin(azimuth) * q[0] + std::cos(azimuth) * q[1], q[2] };
  }
  return turned;
}

} // namespace

TEST(PreservedBorders, OfAnEllipsoidAreWhereItsAngleIsTheta)
{
  constexpr double kSpacing = 0.03;
  for (const double angle : { 60.0, 80.0, 110.0 })
  {
    const MedialAxis axis = preserved(Ellipsoid::mesh(6), kSpacing, angle);
    const auto half = Ellipsoid::border(angle);
    std::size_t onRim = 0;
    double worst = 0.0;
    for (std::size_t p = 0; p < axis.points.size(); ++p)
    {
      if (axis.feature[p] == AxisFeature::Rim)
      {
        ++onRim;
        worst = std::max(worst, Ellipsoid::offBorder(axis.points[p], half));
      }
    }
    EXPECT_GT(onRim, 50u);
    EXPECT_LE(worst, 0.1 * kSpacing) << angle;
    EXPECT_LE(bordersOf(axis, kSpacing).roughness(), 1.05);
    expectTopologyOfSolid(axis);
  }
}

TEST(PreservedPoints, InSmoothCellsAreThoseOfTheSelectedAxis)
{
  const TriangleMesh mesh = Ellipsoid::mesh(5);
  const Grid grid = offCentreGrid(mesh, 0.04);
  const MedialAxis selected = computeMedialAxis(mesh, grid, MedialAxisOptions());
  std::vector<Point3> known = selected.points;
  std::sort(known.begin(), known.end());
  const MedialAxis axis = computeMedialAxis(mesh, grid, preserving());
  const auto same = std::count_if(axis.points.begin(), axis.points.end(),
    [&](const Point3& point) { return std::binary_search(known.begin(), known.end(), point); });
  EXPECT_GT(same, 0.5 * static_cast<double>(axis.points.size()));
  expectTopologyOfSolid(axis);
}

TEST(PreservedBorders, GiveAnEllipsoidItsAreaAtSecondOrder)
{
  const auto half = Ellipsoid::border(60.0);
  int subdivisions = 5;
  for (const double spacing : { 0.06, 0.03, 0.015 })
  {
    const MedialAxis axis = preserved(Ellipsoid::mesh(subdivisions++), spacing);
    EXPECT_LE(relativeError(axis, kPi * half[0] * half[1]), spacing * spacing);
    EXPECT_LE(bordersOf(axis, spacing).roughness(), 1.05);
  }
}

TEST(PreservedBorders, OfARoundedPlateAreSmooth)
{
  constexpr double kSpacing = 0.031;
  const MedialAxis axis = preserved(roundedPlate(0.8, 0.5, 0.3, 6), kSpacing);
  EXPECT_LE(bordersOf(axis, kSpacing).roughness(), 1.05);
  const double halfVoxel = 0.5 * kSpacing * 4.0 * (0.8 + 0.5);
  EXPECT_LE(relativeError(axis, 4.0 * 0.8 * 0.5), halfVoxel / (4.0 * 0.8 * 0.5));
  expectTopologyOfSolid(axis);
}

TEST(PreservedBorders, OfOpenPlatesAreSmooth)
{
  constexpr double kSpacing = 0.031;
  const TriangleMesh mesh = plates(0.3, 0.6);
  const MedialAxis axis = computeMedialAxis(mesh, offCentreGrid(mesh, kSpacing, 0.5), preserving());
  EXPECT_LE(bordersOf(axis, kSpacing).roughness(), 1.05);
  expectTopologyOfSolid(axis);
}

TEST(PreservedBorders, AreWhereRadiusAndLambdaReachTheirLimits)
{
  constexpr double kSpacing = 0.03;
  const TriangleMesh mesh = tilted(box({ 1.1, 0.8, 0.5 }));
  MedialAxisOptions options = preserving();
  options.radius = 0.2;
  const double area = boxAxisArea(0.9, 0.6, 0.3);
  const Grid grid = offCentreGrid(mesh, kSpacing);
  EXPECT_LE(relativeError(computeMedialAxis(mesh, grid, options), area), 0.02);
  options.radius = 0.0;
  options.lambda = 0.2 / std::sqrt(2.0);
  EXPECT_LE(relativeError(computeMedialAxis(mesh, grid, options), area), 0.02);
}

TEST(PreservedCreases, OfABoxAreReached)
{
  const TriangleMesh mesh = tilted(box({ 1.0, 0.7, 0.4 }));
  for (const double spacing : { 0.05, 0.025 })
  {
    const MedialAxis axis = preserved(mesh, spacing);
    EXPECT_LE(relativeError(axis, boxAxisArea(1.0, 0.7, 0.4)), 0.6 * spacing);
    // Places on its edges.
    const std::vector<double> far =
      distancesToPoints({ tilted(Point3{ 1.0, 0.7, 0.0 }), tilted(Point3{ 1.0, -0.7, 0.1 }),
                          tilted(Point3{ -1.0, 0.2, 0.4 }), tilted(Point3{ 0.3, 0.7, -0.4 }) },
        axis.points);
    EXPECT_LE(*std::max_element(far.begin(), far.end()), spacing);
    expectTopologyOfSolid(axis);
  }
}

TEST(PreservedCreases, OfAPrismAreReached)
{
  constexpr double kSpacing = 0.04;
  const MedialAxis axis = preserved(tilted(lPrism(1.0, 0.6)), kSpacing);
  // Places on convex edges.
  const std::vector<double> far =
    distancesToPoints({ tilted(Point3{ -1.0, -1.0, 0.0 }), tilted(Point3{ 1.0, -1.0, 0.1 }),
                        tilted(Point3{ -0.3, -1.0, 0.6 }), tilted(Point3{ 1.0, 0.0, -0.2 }) },
      axis.points);
  EXPECT_LE(*std::max_element(far.begin(), far.end()), kSpacing);
  expectTopologyOfSolid(axis);
}

TEST(SoundCells, TakePointsBackThatLeaveNoArea)
{
  ThinnedAxis axis;
  std::vector<BisectorPoint> before(6);
  for (int i = 0; i < 6; ++i)
  {
    before[i].position = { i / 2, i % 2, 0.0 };
  }
  axis.quads = { { 0, 2, 3, 1 }, { 2, 4, 5, 3 } };
  axis.points.points = before;
  axis.points.points[4].position = { 1.0, 2.0, 0.0 };
  axis.points.points[5].position = { 1.0, 3.0, 0.0 };
  axis.points.points[1].position = { 0.0, 0.8, 0.0 };
  keepCellsSound(before, axis);
  EXPECT_EQ(axis.points.points[4].position, before[4].position);
  EXPECT_EQ(axis.points.points[5].position, before[5].position);
  EXPECT_EQ(axis.points.points[1].position.y, 0.8);
}

TEST(PreservedCurves, RunStraightThroughStraightTubes)
{
  constexpr double kRadius = 0.3;
  constexpr double kHalfLength = 2.0;
  for (const Point3& direction : { Point3{ 0, 0, 1 }, Point3{ 1, 0.1, 0 }, Point3{ 1, 1, 0.05 },
         Point3{ 1, 1, 1 }, Point3{ 0.3, -0.7, 0.5 }, Point3{ -0.2, 0.5, 1 } })
  {
    SCOPED_TRACE(testing::Message() << direction[0] << ' ' << direction[1] << ' ' << direction[2]);
    const TriangleMesh mesh = alongDirection(uvCapsule(kRadius, kHalfLength, 64), direction);
    for (const double spacing : { 0.1, 0.0613, 0.031 })
    {
      SCOPED_TRACE(spacing);
      const MedialAxis axis = preserved(mesh, spacing);
      const std::vector<Point3> line = onlyCurve(axis);
      EXPECT_LE(turning(line), 10.0);
      const double norm = std::hypot(direction[0], direction[1], direction[2]);
      const Point3 end{ direction[0] / norm, direction[1] / norm, direction[2] / norm };
      double worst = 0.0;
      double longest = 0.0;
      for (const Point3& p : line)
      {
        const double along = p[0] * end[0] + p[1] * end[1] + p[2] * end[2];
        const double inside = std::clamp(along, -kHalfLength, kHalfLength);
        worst = std::max(worst,
          std::hypot(p[0] - inside * end[0], p[1] - inside * end[1], p[2] - inside * end[2]));
        longest = std::max(longest, std::abs(along));
      }
      EXPECT_LE(worst, 0.1 * spacing);
      EXPECT_GE(longest, kHalfLength - 3.0 * spacing);
      expectTopologyOfSolid(axis);
    }
  }
}

// Of tubes and balls with facets of uneven sizes, single faces beside a curve may stay for sheets.
TEST(PreservedCurves, ReachTheEndsOfTubesAndBalls)
{
  const auto ball = [](double x, double y) { return Tube{ { x, y, 0.0 }, { x, y, 1e-6 }, 1.0 }; };
  const std::vector<std::vector<Tube>> solids{ { { { -3.0, -1.0, 0.4 }, { 3.0, 1.2, 0.0 }, 0.8 } },
    { { { -1.796, -0.524, -0.706 }, { 1.796, 0.524, 0.706 }, 0.5 } },
    { ball(0.0, 0.0), ball(1.7, 0.0), ball(3.4, 0.0), ball(-1.7, 0.0), ball(0.0, 1.7) } };
  for (const std::vector<Tube>& solid : solids)
  {
    const TriangleMesh mesh = unionOf(solid, 0.0713);
    for (int resolution = 64; resolution <= 120; resolution += 4)
    {
      SCOPED_TRACE(resolution);
      const Grid grid = makeGrid(mesh.bounds(), resolution);
      const MedialAxis axis = computeMedialAxis(mesh, grid, preserving());
      for (const Tube& tube : solid)
      {
        for (const Point3& end : { tube.from, tube.to })
        {
          double nearest = std::numeric_limits<double>::infinity();
          for (const Point3& p : axis.points)
          {
            nearest = std::min(nearest, std::hypot(p[0] - end[0], p[1] - end[1], p[2] - end[2]));
          }
          EXPECT_LT(nearest, 1.5 * grid.spacing[0]);
        }
      }
      expectTopologyOfSolid(axis);
    }
  }
}

TEST(PreservedCurves, RunEvenlyThroughATorus)
{
  for (const bool turned : { false, true })
  {
    const TriangleMesh mesh = torus(1.0, 0.3, 192, 64);
    for (const double spacing : { 0.0731, 0.0413 })
    {
      const MedialAxis axis = preserved(turned ? tilted(mesh) : mesh, spacing);
      std::vector<Point3> ring = onlyCurve(axis);
      EXPECT_EQ(ring.front(), ring.back());
      ring.push_back(ring[1]);
      EXPECT_NEAR(turning(ring), 360.0, 10.0);
      for (const Point3& point : ring)
      {
        const Point3 p = turned ? untilted(point) : point;
        EXPECT_LE(std::hypot(std::hypot(p[0], p[1]) - 1.0, p[2]), 0.1 * spacing);
      }
      expectTopologyOfSolid(axis);
    }
  }
}

TEST(PreservedCurves, AreTheSameForAnyThreads)
{
  const TriangleMesh mesh = tilted(uvCapsule(0.3, 1.0, 32));
  MedialAxisOptions options = preserving();
  options.field.execution.threads = 1;
  const Grid grid = offCentreGrid(mesh, 0.05);
  const MedialAxis one = computeMedialAxis(mesh, grid, options);
  options.field.execution.threads = 5;
  const MedialAxis five = computeMedialAxis(mesh, grid, options);
  EXPECT_EQ(one.points, five.points);
  EXPECT_EQ(one.closestPointB, five.closestPointB);
  EXPECT_EQ(one.lines, five.lines);
}
