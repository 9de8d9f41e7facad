#include "medial/compute_distance_field.h"
#include "medial/medial_solver.h"

#include "medial/error.h"
#include "support/errors.h"
#include "support/field_checks.h"
#include "support/printing.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

using namespace medial;
using namespace medial::test;

namespace
{

const Grid kGrid{ { -1.7, -1.7, -0.9 }, { 0.05, 0.05, 0.05 }, { 69, 69, 37 } };

/// A torus that bends more and more.
std::vector<Point3> bent(const TriangleMesh& mesh, double amount)
{
  std::vector<Point3> points = mesh.points;
  for (Point3& p : points)
  {
    p[2] += amount * std::sin(2.0 * p[0]);
  }
  return points;
}

DistanceField fieldBy(MedialSolver& solver, const Extent& extent,
  const DistanceFieldOptions& options)
{
  DistanceField field;
  field.grid = kGrid;
  const auto count = static_cast<std::size_t>(extent.pointCount());
  field.distance.resize(count);
  field.closestPoint.resize(3 * count);
  field.closestSite.resize(count);
  field.closestFeature.resize(count);
  field.closestCell.resize(count);
  field.statistics = solver.computeField(kGrid, extent,
    { field.distance.data(), field.closestPoint.data(), field.closestSite.data(),
      field.closestFeature.data(), field.closestCell.data() },
    options);
  return field;
}

class MedialSolverBy : public testing::TestWithParam<Engine>
{
protected:
  void SetUp() override { options_.engine = GetParam(); }

  TriangleMesh mesh_ = torus(1.0, 0.4, 40, 20);
  MedialSolver solver_{ mesh_ };
  DistanceFieldOptions options_;
};

} // namespace

TEST_P(MedialSolverBy, FramesAreExact)
{
  for (const double amount : { 0.0, 0.03, 0.06, -0.3 })
  {
    solver_.setPoints(bent(mesh_, amount));
    const DistanceField field = fieldBy(solver_, kGrid.wholeExtent(), options_);
    expectExact(solver_.mesh(), field, randomVoxels(kGrid, 4000));
    const DistanceField fresh = computeDistanceField(solver_.mesh(), kGrid, options_);
    const FieldDifference change = difference(solver_.mesh(), fresh, field);
    EXPECT_LT(change.distance, 1e-3);
    EXPECT_EQ(change.untiedSites, 0U);
  }
}

TEST_P(MedialSolverBy, WhatWasClosestFarAwayDoesNoHarm)
{
  solver_.setPoints(bent(mesh_, 0.0));
  fieldBy(solver_, kGrid.wholeExtent(), options_);
  // All sites elsewhere: the torus turned by a quarter and shifted.
  std::vector<Point3> points = mesh_.points;
  for (Point3& p : points)
  {
    p = { -p[1] + 0.4, p[0] - 0.3, -p[2] + 0.1 };
  }
  solver_.setPoints(points);
  expectExact(solver_.mesh(), fieldBy(solver_, kGrid.wholeExtent(), options_),
    randomVoxels(kGrid, 4000));
}

TEST_P(MedialSolverBy, GridsMayChange)
{
  const Extent part{ { 5, 6, 7 }, { 30, 40, 20 } };
  fieldBy(solver_, kGrid.wholeExtent(), options_);
  const DistanceField small = fieldBy(solver_, part, options_);
  const DistanceField whole = fieldBy(solver_, kGrid.wholeExtent(), options_);
  std::size_t i = 0;
  for (int z = part.min[2]; z <= part.max[2]; ++z)
  {
    for (int y = part.min[1]; y <= part.max[1]; ++y)
    {
      for (int x = part.min[0]; x <= part.max[0]; ++x, ++i)
      {
        const auto j =
          static_cast<std::size_t>((z * kGrid.dimensions[1] + y) * kGrid.dimensions[0] + x);
        ASSERT_NEAR(small.distance[i], whole.distance[j], 1e-3 * 0.05);
      }
    }
  }
}

TEST_P(MedialSolverBy, SignFollowsAMeshThatTurnsInsideOut)
{
  std::vector<Point3> points = mesh_.points;
  for (Point3& p : points)
  {
    p[0] = -p[0]; // a mirror image faces inwards
  }
  solver_.setPoints(points);
  EXPECT_LT(solver_.connectivity().signedVolume, 0.0);
  const DistanceField field = fieldBy(solver_, kGrid.wholeExtent(), options_);
  const DistanceField fresh = computeDistanceField(solver_.mesh(), kGrid, options_);
  EXPECT_LT(difference(solver_.mesh(), fresh, field).distance, 1e-3);
}

TEST_P(MedialSolverBy, AxesAreThoseOfTheMesh)
{
  MedialAxisOptions options;
  options.field = options_;
  solver_.computeAxis(kGrid, options);
  solver_.setPoints(bent(mesh_, 0.1));
  const MedialAxis axis = solver_.computeAxis(kGrid, options);
  const MedialAxis fresh = computeMedialAxis(solver_.mesh(), kGrid, options);
  ASSERT_GT(axis.points.size(), 100U);
  EXPECT_EQ(axis.points, fresh.points);
  EXPECT_EQ(axis.radius, fresh.radius);
}

TEST_P(MedialSolverBy, BadPointsAreRefusedAndLeaveTheMeshAlone)
{
  std::vector<Point3> points = mesh_.points;
  points.pop_back();
  expectError([&] { solver_.setPoints(points); }, ErrorCode::InvalidInput);
  points = mesh_.points;
  points[7][1] = std::numeric_limits<double>::quiet_NaN();
  expectError([&] { solver_.setPoints(points); }, ErrorCode::InvalidInput);
  EXPECT_EQ(solver_.mesh().points, mesh_.points);
}

INSTANTIATE_TEST_SUITE_P(All, MedialSolverBy,
  testing::Values(Engine::Device, Engine::Rasteriser, Engine::Processor));
