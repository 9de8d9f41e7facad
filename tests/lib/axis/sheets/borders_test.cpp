#include "medial/axis_curves.h"
#include "medial/cell_topology.h"
#include "medial/compute_medial_axis.h"

#include "support/axes.h"
#include "support/border_roughness.h"
#include "support/bordered_shapes.h"
#include "support/medial_checks.h"
#include "support/medial_truth.h"
#include "support/model_formats.h"
#include "support/models.h"
#include "support/shapes.h"
#include "support/transforms.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

using namespace medial;
using namespace medial::test;

namespace
{

const double kPi = std::acos(-1.0);

MedialAxis compute(const TriangleMesh& mesh, double spacing, const MedialAxisOptions& options)
{
  return computeMedialAxis(mesh, offCentreGrid(mesh, spacing), options);
}

MedialAxis compute(const TriangleMesh& mesh, double spacing, double angle)
{
  MedialAxisOptions options;
  options.angle = angle;
  return compute(mesh, spacing, options);
}

double minimum(const std::vector<float>& values)
{
  return static_cast<double>(*std::min_element(values.begin(), values.end()));
}

double minAngle(const MedialAxis& axis)
{
  return minimum(axis.separationAngle);
}

double relativeError(const MedialAxis& axis, double area)
{
  return std::abs(areaOf(axis) / area - 1.0);
}

} // namespace

TEST(Borders, OfAnEllipsoidAreWhereItsAngleIsTheta)
{
  for (const double angle : { 60.0, 80.0, 110.0 })
  {
    const double spacing = 0.03;
    const MedialAxis axis = compute(Ellipsoid::mesh(6), spacing, angle);
    const auto half = Ellipsoid::border(angle);
    std::size_t onRim = 0;
    for (std::size_t p = 0; p < axis.points.size(); ++p)
    {
      if (axis.feature[p] == AxisFeature::Rim)
      {
        ++onRim;
        EXPECT_LE(Ellipsoid::offBorder(axis.points[p], half), 0.1 * spacing);
      }
    }
    EXPECT_GT(onRim, 50u);
    EXPECT_LE(bordersOf(axis, spacing).roughness(), 1.05);
  }
}

TEST(Borders, GiveAnEllipsoidItsAreaAtSecondOrder)
{
  const auto half = Ellipsoid::border(60.0);
  int subdivisions = 5;
  for (const double spacing : { 0.06, 0.03, 0.015 })
  {
    const MedialAxis axis = compute(Ellipsoid::mesh(subdivisions++), spacing, 60.0);
    EXPECT_LE(relativeError(axis, kPi * half[0] * half[1]), spacing * spacing);
    EXPECT_LE(bordersOf(axis, spacing).roughness(), 1.05);
  }
}

TEST(Borders, OfOneSheetAreOneClosedLine)
{
  const MedialAxis axis = compute(Ellipsoid::mesh(6), 0.03, 60.0);
  EXPECT_EQ(topologyOf(axis).eulerCharacteristic, 1);
  const std::vector<AxisCurve> curves = axisCurves(edgesOf(axis), axis.points.size());
  ASSERT_EQ(curves.size(), 1u);
  EXPECT_EQ(curves[0].kind, AxisFeature::Rim);
  EXPECT_EQ(curves[0].points.front(), curves[0].points.back());
}

TEST(Borders, OfARoundedPlateAreSmooth)
{
  constexpr double kSpacing = 0.031;
  const MedialAxis axis = compute(roundedPlate(0.8, 0.5, 0.3, 6), kSpacing, 60.0);
  EXPECT_LE(bordersOf(axis, kSpacing).roughness(), 1.05);
  const double halfVoxel = 0.5 * kSpacing * 4.0 * (0.8 + 0.5);
  EXPECT_LE(relativeError(axis, 4.0 * 0.8 * 0.5), halfVoxel / (4.0 * 0.8 * 0.5));
}

TEST(Borders, OfOpenPlatesAreWhereTheirAngleIsTheta)
{
  // Beyond the plates the closest points stay on their edges.
  constexpr double kGap = 0.3;
  constexpr double kHalf = 0.6;
  const double beyond = 0.5 * std::sqrt(3.0) * kGap;
  const double truth = 4.0 * kHalf * (kHalf + 2.0 * beyond) + kPi * beyond * beyond;
  for (const double spacing : { 0.04, 0.02 })
  {
    MedialAxisOptions options;
    const TriangleMesh mesh = plates(kGap, kHalf);
    const MedialAxis axis = computeMedialAxis(mesh, offCentreGrid(mesh, spacing, 0.5), options);
    EXPECT_LE(relativeError(axis, truth), 6.0 * spacing * spacing);
    EXPECT_GE(minAngle(axis), 59.0);
  }
}

TEST(Borders, OfFlatSheetsAreTheirSeams)
{
  for (const double angle : { 100.0, 120.0, 150.0 })
  {
    for (const double spacing : { 0.04, 0.02 })
    {
      const MedialAxis axis = compute(tilted(box({ 1.1, 0.8, 0.5 })), spacing, angle);
      EXPECT_LE(relativeError(axis, 4.0 * 0.6 * 0.3), 5.0 * spacing * spacing);
      EXPECT_GE(minAngle(axis), 179.0);
    }
  }
}

TEST(Borders, LeaveNoPointOfFlatSheetsBelowTheta)
{
  for (const double angle : { 30.0, 60.0, 85.0, 95.0, 140.0 })
  {
    const MedialAxis axis = compute(tilted(box({ 1.1, 0.8, 0.5 })), 0.03, angle);
    EXPECT_GE(minAngle(axis), angle);
  }
}

/// The part of a box's axis with balls of a radius or more is the axis of a smaller box.
TEST(Borders, AreWhereTheRadiusReachesItsLimit)
{
  for (const double spacing : { 0.04, 0.02 })
  {
    MedialAxisOptions options;
    options.radius = 0.2;
    const MedialAxis axis = compute(tilted(box({ 1.1, 0.8, 0.5 })), spacing, options);
    EXPECT_LE(relativeError(axis, boxAxisArea(0.9, 0.6, 0.3)), 5.0 * spacing * spacing);
    EXPECT_GE(minimum(axis.radius), options.radius - 0.01 * spacing);
  }
}

TEST(Borders, AreWhereLambdaReachesItsLimit)
{
  for (const double spacing : { 0.04, 0.02 })
  {
    MedialAxisOptions options;
    options.lambda = 0.2 / std::sqrt(2.0);
    const MedialAxis axis = compute(tilted(box({ 1.1, 0.8, 0.5 })), spacing, options);
    EXPECT_LE(relativeError(axis, boxAxisArea(0.9, 0.6, 0.3)), 5.0 * spacing * spacing);
    EXPECT_GE(minimum(axis.lambda), options.lambda - 0.01 * spacing);
  }
}

TEST(Borders, AreTheSameForAnyThreads)
{
  const TriangleMesh mesh = Ellipsoid::mesh(4);
  MedialAxisOptions options;
  options.field.execution.threads = 1;
  const MedialAxis one = compute(mesh, 0.03, options);
  options.field.execution.threads = 5;
  const MedialAxis five = compute(mesh, 0.03, options);
  EXPECT_EQ(one.points, five.points);
  EXPECT_EQ(one.separationAngle, five.separationAngle);
  EXPECT_EQ(one.quads, five.quads);
  EXPECT_EQ(one.triangles, five.triangles);
}

/// Facets there are as large as voxels, and turn by up to half a right angle.
TEST(Borders, OfRealMeshesAreSmootherThanVoxels)
{
  for (const char* file : { "paper/bunny_69k_closed.off", "paper/gargoyle_20k.off" })
  {
    if (const auto path = modelPath(file))
    {
      const TriangleMesh mesh = loadMesh(*path);
      const Grid grid = makeGrid(mesh.bounds(), 256, 0.05);
      const MedialAxis axis = computeMedialAxis(mesh, grid);
      EXPECT_LE(bordersOf(axis, grid.spacing[0]).roughness(), 1.08) << file;
      EXPECT_GE(minAngle(axis), 0.8 * 60.0) << file;
    }
  }
}
