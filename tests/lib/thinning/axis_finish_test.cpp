#include "medial/compute_medial_axis.h"

#include "support/axes.h"
#include "support/border_roughness.h"
#include "support/bordered_shapes.h"
#include "support/medial_checks.h"
#include "support/medial_truth.h"
#include "support/shapes.h"
#include "support/voxel_topology.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

using namespace medial;
using namespace medial::test;

namespace
{

const double kPi = std::acos(-1.0);

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
