#include "medial/compute_medial_axis.h"
#include "medial/error.h"
#include "medial/point_distance.h"

#include "support/errors.h"
#include "support/medial_checks.h"
#include "support/medial_truth.h"
#include "support/shapes.h"
#include "support/transforms.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

using namespace medial;
using namespace medial::test;

namespace
{

const double kPi = std::acos(-1.0);

MedialAxis compute(const TriangleMesh& mesh, double spacing, double angle,
  Side side = Side::Interior, Representation representation = Representation::Surface)
{
  MedialAxisOptions options;
  options.angle = angle;
  options.side = side;
  options.representation = representation;
  return computeMedialAxis(mesh, offCentreGrid(mesh, spacing), options);
}

/// A convex wedge scaled so that its axis forks at distance kFork from the edge; up to there the
/// axis is the bisector of its two faces, with separation angle 180 - dihedral.
class WedgeAxis : public testing::TestWithParam<double>
{
protected:
  static constexpr double kFork = 0.5;
  static constexpr double kHalfLength = 0.3; ///< without the part that the caps influence
  static constexpr double kSpacing = 0.0231;

  static double separation() { return 180.0 - GetParam(); }

  static TriangleMesh mesh()
  {
    const double half = 0.5 * GetParam() * kPi / 180.0;
    const double width = kFork * (1.0 + std::sin(half)) / std::cos(half);
    return wedge(GetParam(), 2.0 * (kHalfLength + kFork * std::sin(half)), width);
  }

  /// Three voxels away from everything else.
  static bool nearBisector(const Point3& p)
  {
    constexpr double kMargin = 3.0 * kSpacing;
    return p[0] > kMargin && p[0] < kFork - kMargin && std::abs(p[2]) < kHalfLength - kMargin;
  }

  /// Points of the axis near the bisector, in the wedge's own coordinates.
  static std::vector<Point3> bisectorPoints(const MedialAxis& axis)
  {
    std::vector<Point3> points;
    for (const Point3& point : axis.points)
    {
      if (nearBisector(untilted(point)))
      {
        points.push_back(untilted(point));
      }
    }
    return points;
  }

  static double uncoveredBisector(const std::vector<Point3>& points)
  {
    std::vector<Point3> places;
    for (double x = 0.0; x < kFork; x += kSpacing)
    {
      for (double z = -kHalfLength; z < kHalfLength; z += kSpacing)
      {
        if (nearBisector({ x, 0.0, z }))
        {
          places.push_back({ x, 0.0, z });
        }
      }
    }
    const std::vector<double> distances = distancesToPoints(places, points);
    return *std::max_element(distances.begin(), distances.end());
  }
};

/// Points of an axis within `radius` of the z axis, away from the ends of a shape.
std::size_t countNearZ(const MedialAxis& axis, double radius, double halfLength)
{
  return static_cast<std::size_t>(std::count_if(axis.points.begin(), axis.points.end(),
    [&](const Point3& p)
    { return std::hypot(p[0], p[1]) < radius && std::abs(p[2]) < halfLength; }));
}

class ReflexEdge : public testing::TestWithParam<double>
{
};

double surfaceArea(const MedialAxis& axis)
{
  double sum = 0.0;
  const auto add = [&](std::int64_t a, std::int64_t b, std::int64_t c)
  {
    const Point3& p = axis.points[a];
    const Point3& q = axis.points[b];
    const Point3& r = axis.points[c];
    const Point3 u{ q[0] - p[0], q[1] - p[1], q[2] - p[2] };
    const Point3 v{ r[0] - p[0], r[1] - p[1], r[2] - p[2] };
    sum += 0.5 *
      std::hypot(u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]);
  };
  for (const auto& q : axis.quads)
  {
    add(q[0], q[1], q[2]);
    add(q[0], q[2], q[3]);
  }
  for (const auto& t : axis.triangles)
  {
    add(t[0], t[1], t[2]);
  }
  return sum;
}

} // namespace

TEST_P(WedgeAxis, IsThereBelowItsSeparationAngle)
{
  const MedialAxis axis = compute(tilted(mesh()), kSpacing, separation() - 5.0);
  const std::vector<Point3> points = bisectorPoints(axis);
  EXPECT_LE(uncoveredBisector(points), 1.5 * kSpacing);
  for (const Point3& point : points)
  {
    EXPECT_NEAR(point[1], 0.0, 0.3 * kSpacing);
  }
}

TEST_P(WedgeAxis, IsGoneAboveItsSeparationAngle)
{
  const MedialAxis axis = compute(tilted(mesh()), kSpacing, separation() + 5.0);
  EXPECT_TRUE(bisectorPoints(axis).empty());
}

TEST_P(WedgeAxis, HasItsSeparationAngleEverywhere)
{
  const MedialAxis axis =
    compute(tilted(mesh()), kSpacing, separation() - 5.0, Side::Interior, Representation::Points);
  for (std::size_t i = 0; i < axis.points.size(); ++i)
  {
    if (nearBisector(untilted(axis.points[i])))
    {
      EXPECT_NEAR(static_cast<double>(axis.separationAngle[i]), separation(), 0.1);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Dihedral, WedgeAxis, testing::Values(30.0, 60.0, 80.0, 110.0, 140.0));

TEST_P(ReflexEdge, OfAWedgeHasNoAxis)
{
  const TriangleMesh mesh = wedge(GetParam(), 4.0, 1.0);
  for (const double angle : { 20.0, 60.0 })
  {
    const MedialAxis axis = compute(mesh, 0.0431, angle);
    EXPECT_GT(axis.points.size(), 0u);
    EXPECT_EQ(countNearZ(axis, 0.3, 0.8), 0u);
  }
}

INSTANTIATE_TEST_SUITE_P(Dihedral, ReflexEdge, testing::Values(200.0, 270.0, 330.0));

TEST(MedialAxisSelection, HasNothingAtTheReflexEdgeOfAnLPrism)
{
  const MedialAxis axis = compute(lPrism(1.0, 2.0), 0.0431, 20.0);
  EXPECT_GT(axis.points.size(), 0u);
  EXPECT_EQ(countNearZ(axis, 0.35, 0.8), 0u);
}

TEST(MedialAxisSelection, OfTwoOpenPlatesIsTheMiddlePlane)
{
  const double gap = 0.6;
  const double h = 0.0311;
  const MedialAxis axis = compute(plates(gap, 1.0), h, 60.0);
  EXPECT_EQ(axis.side, Side::Both);
  EXPECT_EQ(axis.sign, SignMethod::None);
  // Beyond the plates the separation angle falls below 60 degrees at radius `gap`.
  const double reach = 1.0 + std::sqrt(0.75) * gap + 1.5 * h;
  for (const Point3& p : axis.points)
  {
    EXPECT_NEAR(p[2], 0.0, 0.3 * h);
    EXPECT_LE(std::max(std::abs(p[0]), std::abs(p[1])), reach);
  }
}

TEST(MedialAxisSelection, OfTwoOpenPlatesReachesTheirRims)
{
  const double h = 0.0311;
  const MedialAxis axis = compute(plates(0.6, 1.0), h, 60.0);
  std::vector<Point3> places;
  for (double x = -1.0; x <= 1.0; x += h)
  {
    places.insert(places.end(), { { x, 1.0, 0.0 }, { -1.0, x, 0.0 }, { x, x, 0.0 } });
  }
  const std::vector<double> distances = distancesToPoints(places, axis.points);
  EXPECT_LE(*std::max_element(distances.begin(), distances.end()), 1.5 * h);
}

TEST(MedialAxisSelection, OutsideAConvexSolidIsEmpty)
{
  const MedialAxis axis = compute(box({ 1.0, 0.7, 0.5 }), 0.057, 30.0, Side::Exterior);
  EXPECT_EQ(axis.points.size(), 0u);
  EXPECT_EQ(axis.cellCount(), 0);
}

TEST(MedialAxisSelection, OutsideAShellIsTheCentreOfItsHole)
{
  const double h = 0.0531;
  const MedialAxis axis = compute(shell(0.5, 1.0, 4), h, 60.0, Side::Exterior);
  EXPECT_GT(axis.points.size(), 0u);
  for (const Point3& p : axis.points)
  {
    EXPECT_LE(std::hypot(p[0], p[1], p[2]), thickening(h, 60.0));
  }
}

TEST(MedialAxisSelection, OfBothSidesIsThatOfEither)
{
  const TriangleMesh mesh = shell(0.5, 1.0, 3);
  const auto points = [&](Side side)
  { return compute(mesh, 0.0831, 60.0, side, Representation::Points).points.size(); };
  EXPECT_GT(points(Side::Interior), points(Side::Exterior));
  EXPECT_EQ(points(Side::Both), points(Side::Interior) + points(Side::Exterior));
}

TEST(MedialAxisSelection, SurfaceOfABoxHasItsArea)
{
  const MedialAxis axis = compute(tilted(box({ 1.1, 0.8, 0.5 })), 0.0213, 60.0);
  const double truth = 4.0 * 0.6 * 0.3 + 4.0 * std::sqrt(2.0) * (1.1 + 0.8 - 0.25);
  // The sheets end a voxel or two before the edges of the box.
  EXPECT_LE(surfaceArea(axis), 1.02 * truth);
  EXPECT_GE(surfaceArea(axis), 0.85 * truth);
}

TEST(MedialAxisSelection, RefusesAnglesOutsideItsRange)
{
  for (const double angle : { 0.0, 180.0, -10.0, 400.0, std::numeric_limits<double>::quiet_NaN() })
  {
    expectError([&] { compute(box({ 1.0, 1.0, 1.0 }), 0.5, angle); }, ErrorCode::InvalidInput);
  }
}

TEST(MedialAxisSelection, EveryPointOfSurfacesAndPointSetsHasTheAngle)
{
  const TriangleMesh mesh = ellipsoid(1.0, 0.7, 0.4, 4);
  for (const Representation representation : { Representation::Surface, Representation::Points })
  {
    const MedialAxis axis = compute(mesh, 0.031, 70.0, Side::Interior, representation);
    ASSERT_FALSE(axis.separationAngle.empty());
    EXPECT_GE(*std::min_element(axis.separationAngle.begin(), axis.separationAngle.end()), 69.99f);
  }
}

TEST(MedialAxisSelection, LambdaAndRadiusLimitEveryCrossing)
{
  // On the sheets to the edges of a box the radius falls to 0 and lambda is radius / sqrt 2; on the
  // middle rectangle both are 0.5.
  const TriangleMesh mesh = box({ 1.0, 0.8, 0.5 });
  constexpr double kSpacing = 0.031;
  MedialAxisOptions options;
  options.representation = Representation::Points;
  const Grid grid = offCentreGrid(mesh, kSpacing);
  const MedialAxis all = computeMedialAxis(mesh, grid, options);
  const auto min = [](const std::vector<float>& values)
  { return *std::min_element(values.begin(), values.end()); };
  EXPECT_LT(min(all.lambda), 0.05f);

  options.lambda = 0.2;
  const MedialAxis byLambda = computeMedialAxis(mesh, grid, options);
  EXPECT_NEAR(static_cast<double>(min(byLambda.lambda)), 0.2, 0.5 * kSpacing);
  EXPECT_GE(min(byLambda.lambda), 0.1999f);

  options.lambda = 0.0;
  options.radius = 0.2;
  const MedialAxis byRadius = computeMedialAxis(mesh, grid, options);
  EXPECT_GE(min(byRadius.radius), 0.1999f);
  EXPECT_LT(byLambda.points.size(), byRadius.points.size());
  EXPECT_LT(byRadius.points.size(), all.points.size());

  options.radius = 0.51;
  EXPECT_TRUE(computeMedialAxis(mesh, grid, options).points.empty());
}

TEST(MedialAxisSelection, NegativeLimitsAreErrors)
{
  const TriangleMesh mesh = box({ 1.0, 0.8, 0.5 });
  MedialAxisOptions options;
  options.lambda = -0.1;
  EXPECT_THROW(computeMedialAxis(mesh, makeGrid(mesh.bounds(), 16), options), Error);
  options.lambda = 0.0;
  options.radius = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(computeMedialAxis(mesh, makeGrid(mesh.bounds(), 16), options), Error);
}

TEST(MedialAxisSelection, ACapsuleIsLinesAlongItsMiddle)
{
  const TriangleMesh mesh = uvCapsule(0.3, 0.6, 64);
  const MedialAxis axis = compute(mesh, 0.0431, 60.0);
  EXPECT_GT(axis.lines.size(), 20u);
  for (const auto& line : axis.lines)
  {
    for (const std::int64_t p : line)
    {
      EXPECT_LE(std::hypot(axis.points[p][0], axis.points[p][1]), 0.3 * 0.0431);
    }
  }
}

/// Between two grid points in a shell that bends within a voxel lies a part of the hollow.
TEST(MedialAxisSelection, BallsInsideLieInsideWhereTheWallIsAsThinAsAVoxel)
{
  for (const double wall : { 0.08, 0.16, 0.3 })
  {
    const TriangleMesh mesh = shell(0.7, 0.7 + wall, 3);
    const PointDistance distance(mesh);
    for (const double spacing : { 0.17, 0.21, 0.29, 0.37 })
    {
      for (const Representation representation :
        { Representation::Surface, Representation::Points })
      {
        SCOPED_TRACE(testing::Message() << wall << ' ' << spacing);
        const MedialAxis axis = compute(mesh, spacing, 20.0, Side::Interior, representation);
        const std::vector<double> distances = distance.compute(axis.points).distance;
        for (std::size_t p = 0; p < distances.size(); ++p)
        {
          EXPECT_NEAR(distances[p], -axis.radius[p], 1e-5) << p;
        }
      }
    }
  }
}

/// The corners of voxel faces lie up to a diagonal away from the axis; their angles are those of
/// the axis.
TEST(MedialAxisSelection, CornersOfVoxelFacesSeeBothSides)
{
  const TriangleMesh mesh = box({ 1.0, 0.8, 0.2 });
  const MedialAxis axis = compute(mesh, 0.043, 120.0, Side::Interior, Representation::Faces);
  ASSERT_GT(axis.points.size(), 100u);
  EXPECT_GE(*std::min_element(axis.separationAngle.begin(), axis.separationAngle.end()), 80.0f);
}
