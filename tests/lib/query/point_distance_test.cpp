#include "medial/point_distance.h"

#include "medial/error.h"
#include "support/brute_force.h"
#include "support/errors.h"
#include "support/point_math.h"
#include "support/shapes.h"
#include "support/transforms.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <thread>
#include <vector>

using namespace medial;
using namespace medial::test;

namespace
{

const Bounds kAround{ { -1.5, -1.5, -1.5 }, { 1.5, 1.5, 1.5 } };

/// Expects exact magnitudes, and closest points that are what the other arrays say of them.
void expectExact(const TriangleMesh& mesh, const std::vector<Point3>& points)
{
  const PointDistances found = PointDistance(mesh, SignMethod::None).compute(points);
  const double size = mesh.bounds().diagonal();
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    const Hit hit = closestOnMesh(mesh, points[i]);
    const double tolerance = 1e-12 * (hit.distance + size);
    ASSERT_NEAR(found.distance[i], hit.distance, tolerance);
    ASSERT_EQ(found.closestFeature[i], hit.kind);
    const Point3 vector = minus(found.closestPoint[i], points[i]);
    ASSERT_NEAR(length(vector), hit.distance, tolerance);
    ASSERT_NEAR(distanceToCell(mesh, found.closestCell[i], found.closestPoint[i]), 0.0, tolerance);
    for (int axis = 0; axis < 3; ++axis)
    {
      ASSERT_NEAR(found.direction[i][axis] * hit.distance, vector[axis], 2.0 * tolerance);
    }
  }
}

/// Expects the sign of the winding number, which is that of `outwards`.
void expectInside(const TriangleMesh& mesh, const TriangleMesh& outwards, SignMethod method)
{
  const std::vector<Point3> points = randomPoints(kAround, 2000, 5);
  const PointDistance query(mesh, method);
  const PointDistances found = query.compute(points);
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    ASSERT_EQ(found.distance[i]<0.0, windingNumber(outwards, points[i])> 0.5) << i;
  }
}

/// Random points at a distance from the origin.
std::vector<Point3> onSphere(double radius, int count)
{
  std::vector<Point3> points = randomPoints(kAround, count, 7);
  for (Point3& x : points)
  {
    const double scale = radius / length(x);
    x = { scale * x[0], scale * x[1], scale * x[2] };
  }
  return points;
}

TriangleMesh openSphere()
{
  TriangleMesh mesh = icosphere(1.0, 2);
  mesh.triangles.resize(mesh.triangles.size() - 3);
  mesh.triangleCells.resize(mesh.triangles.size());
  return mesh;
}

} // namespace

TEST(PointDistance, IsExactForAnyMesh)
{
  const std::vector<Point3> points = randomPoints(kAround, 500, 3);
  expectExact(box({ 1.0, 0.7, 0.4 }), points);
  expectExact(torus(1.0, 0.3, 40, 20), points);
  expectExact(shell(0.6, 1.0, 2), points);
  expectExact(randomSoup(200, 3), points);
  expectExact(hair(1.0, 5), points);
  expectExact(makeMesh({ { 0.0, 0.0, 0.0 }, { 1.0, 0.0, 0.0 }, { 0.0, 1.0, 0.0 }, { 0.0, 0.0, 2.0 },
                         { 1.0, 1.0, 2.0 }, { 3.0, 0.5, 1.0 } },
                { { 0, 1, 2 } }, { { 3, 4 } }, { 5 }),
    points);
}

TEST(PointDistance, IsExactFarAwayAndAtAnySize)
{
  const TriangleMesh sphere = icosphere(1.0, 2);
  expectExact(sphere, { { 1e6, 0.0, 1e6 }, { -3e9, 2e9, 1.0 }, { 1e-9, 2e-9, -1e-9 } });
  for (const double size : { 1e-6, 1e6 })
  {
    std::vector<Point3> points = randomPoints(kAround, 200, 4);
    for (Point3& point : points)
    {
      point = { point[0] * size, point[1] * size, point[2] * size };
    }
    expectExact(scaled(sphere, size), points);
  }
}

TEST(PointDistance, DescribesTheClosestPlaceOfABox)
{
  const PointDistances found = PointDistance(box({ 2.0, 1.0, 1.0 }))
                                 .compute({ { 0.1, 0.2, 3.0 }, { 0.5, 2.0, 2.0 }, { 3.0, 2.0, 2.0 },
                                   { 0.1, 0.2, 0.5 }, { 0.1, 0.2, 1.0 } });
  const std::vector<double> distances{ 2.0, std::sqrt(2.0), std::sqrt(3.0), -0.5, 0.0 };
  for (std::size_t i = 0; i < distances.size(); ++i)
  {
    EXPECT_NEAR(found.distance[i], distances[i], 1e-14);
  }
  EXPECT_EQ(found.closestFeature[0], Feature::Face);
  EXPECT_EQ(found.closestFeature[1], Feature::Edge);
  EXPECT_EQ(found.closestFeature[2], Feature::Vertex);
  EXPECT_NEAR(found.direction[0][2], -1.0, 1e-14);
  EXPECT_NEAR(found.direction[3][2], 1.0, 1e-14);
  EXPECT_EQ(found.direction[4], (Point3{ 0.0, 0.0, 0.0 })); // on the surface
}

TEST(PointDistance, SignIsThatOfTheWindingNumber)
{
  const TriangleMesh hollow = shell(0.6, 1.0, 2);
  expectInside(hollow, hollow, SignMethod::Auto);
  expectInside(flipOrientation(hollow), hollow, SignMethod::Winding);
  expectInside(hollow, hollow, SignMethod::Pseudonormal);
  const TriangleMesh overlapping =
    appended(box({ 0.8, 0.6, 0.6 }), translated(box({ 0.6, 0.6, 0.6 }), { 0.5, 0.3, 0.2 }));
  expectInside(overlapping, overlapping, SignMethod::Auto);
  expectInside(openSphere(), openSphere(), SignMethod::Auto);
}

// Lines along x through these points pass through corners and edges of the box, and along its
// faces.
TEST(PointDistance, SignHoldsWhereLinesMeetCornersEdgesAndFaces)
{
  const TriangleMesh mesh = subdivided(box({ 1.0, 1.0, 1.0 }), 2);
  std::vector<Point3> points;
  for (int i = -6; i <= 6; ++i)
  {
    for (int j = -6; j <= 6; ++j)
    {
      for (int k = -6; k <= 6; ++k)
      {
        points.push_back({ 0.25 * i, 0.25 * j, 0.25 * k });
      }
    }
  }
  const PointDistances found = PointDistance(mesh).compute(points);
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    const auto& [x, y, z] = points[i];
    const double largest = std::max({ std::abs(x), std::abs(y), std::abs(z) });
    if (largest == 1.0)
    {
      EXPECT_EQ(found.distance[i], 0.0);
    }
    else
    {
      EXPECT_EQ(found.distance[i] < 0.0, largest < 1.0) << x << " " << y << " " << z;
    }
  }
}

// So far away, all places of a mesh are equally near in double precision.
TEST(PointDistance, FarPointsAreOutside)
{
  for (const TriangleMesh& mesh :
    { box({ 2.0, 1.0, 0.5 }), box({ 2.0, 1.0, 5e-6 }), icosphere(1.0, 3) })
  {
    for (const SignMethod method : { SignMethod::Pseudonormal, SignMethod::Winding })
    {
      const PointDistance query(mesh, method);
      for (const double radius : { 1e3, 1e10, 1e12, 1e15, 1e16, 1e17 })
      {
        for (const double distance : query.compute(onSphere(radius, 2000)).distance)
        {
          ASSERT_NEAR(distance, radius, 3.0 + 1e-15 * radius);
        }
      }
      EXPECT_LT(query.compute({ { 0.01, 0.02, 1e-6 } }).distance[0], 0.0);
    }
  }
}

TEST(PointDistance, SaysHowTheSignWasFound)
{
  EXPECT_EQ(PointDistance(box({ 1.0, 1.0, 1.0 })).sign().method, SignMethod::Winding);
  EXPECT_EQ(PointDistance(randomSoup(2000, 3)).sign().method, SignMethod::None);
  EXPECT_EQ(PointDistance(box({ 1.0, 1.0, 1.0 }), SignMethod::None).sign().method,
    SignMethod::None);
  EXPECT_THROW(PointDistance(openSphere(), SignMethod::Pseudonormal), Error);
}

// Points between the sheets of a box have several closest places.
TEST(PointDistance, DoesNotDependOnThreadsNorOnTheOtherPoints)
{
  const TriangleMesh mesh = subdivided(box({ 1.0, 0.8, 0.6 }), 3);
  std::vector<Point3> points = randomPoints(kAround, 3000, 8);
  for (std::size_t i = 0; i < points.size(); i += 2)
  {
    points[i] = { std::round(8.0 * points[i][0]) / 8.0, std::round(8.0 * points[i][1]) / 8.0, 0.0 };
  }
  const PointDistance query(mesh);
  const PointDistances all = query.compute(points, { 1 });
  const auto expectSame = [&](const PointDistances& found, std::size_t i, std::size_t k)
  {
    ASSERT_EQ(found.distance[k], all.distance[i]);
    ASSERT_EQ(found.closestPoint[k], all.closestPoint[i]);
    ASSERT_EQ(found.closestCell[k], all.closestCell[i]);
    ASSERT_EQ(found.closestFeature[k], all.closestFeature[i]);
  };
  const PointDistances onThree = query.compute(points, { 3 });
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    expectSame(onThree, i, i);
    expectSame(query.compute({ points[i] }), i, 0);
  }
}

TEST(PointDistance, ServesSeveralThreadsAtOnce)
{
  const TriangleMesh mesh = torus(1.0, 0.3, 40, 20);
  const PointDistance query(mesh);
  std::vector<std::thread> threads;
  for (std::uint32_t seed = 0; seed < 4; ++seed)
  {
    threads.emplace_back(
      [&, seed]
      {
        const std::vector<Point3> points = randomPoints(kAround, 500, seed);
        const PointDistances found = query.compute(points);
        for (std::size_t i = 0; i < points.size(); ++i)
        {
          EXPECT_NEAR(std::abs(found.distance[i]), closestOnMesh(mesh, points[i]).distance, 1e-12);
        }
      });
  }
  for (std::thread& thread : threads)
  {
    thread.join();
  }
}

TEST(PointDistance, NamesPointsThatItCannotUse)
{
  const PointDistance query(box({ 1.0, 1.0, 1.0 }));
  expectError(
    [&] {
      query.compute({ { 0.0, 0.0, 0.0 }, { 0.0, std::nan(""), 0.0 } });
    },
    ErrorCode::InvalidInput, "point 1");
  EXPECT_THROW(PointDistance(TriangleMesh{}), Error);
  EXPECT_TRUE(query.compute({}).distance.empty());
}

TEST(FarthestPoint, IsFoundInsideATriangle)
{
  // Three points, and the triangle between them: its circumcentre is farthest.
  const std::vector<Point3> corners{ { 0.0, 0.0, 0.0 }, { 1.0, 0.0, 0.0 }, { 0.0, 1.0, 0.0 } };
  const FarthestPoint found = PointDistance(makeMesh(corners, {}, {}, { 0, 1, 2 }))
                                .farthest(makeMesh(corners, { { 0, 1, 2 } }));
  EXPECT_NEAR(found.distance, std::sqrt(0.5), 1e-3);
  EXPECT_LE(found.distance, std::sqrt(0.5));
  EXPECT_GE(found.bound, std::sqrt(0.5));
  EXPECT_NEAR(found.point[0], 0.5, 0.03);
  EXPECT_NEAR(found.point[1], 0.5, 0.03);
}

TEST(FarthestPoint, IsFoundOnSegmentsAndPoints)
{
  const PointDistance origin(makeMesh({ { 0.0, 0.0, 0.0 }, { 2.0, 0.0, 0.0 } }, {}, {}, { 0, 1 }));
  const FarthestPoint middle =
    origin.farthest(makeMesh({ { 0.0, 0.0, 0.0 }, { 2.0, 0.0, 0.0 } }, {}, { { 0, 1 } }), 1e-6);
  EXPECT_NEAR(middle.distance, 1.0, 3e-6);
  EXPECT_NEAR(origin.farthest(makeMesh({ { 0.0, 5.0, 0.0 } }, {}, {}, { 0 })).distance, 5.0, 1e-12);
}

TEST(FarthestPoint, BoundsWhatSamplesFind)
{
  const TriangleMesh from = torus(0.8, 0.3, 24, 12);
  for (const TriangleMesh& mesh :
    { box({ 0.7, 0.9, 0.2 }), icosphere(0.9, 1), randomSoup(40, 5), shell(0.3, 1.2, 1) })
  {
    const FarthestPoint found = PointDistance(mesh).farthest(from, 1e-3);
    double largest = 0.0;
    for (const Point3& point : subdivided(from, 3).points)
    {
      largest = std::max(largest, closestOnMesh(mesh, point).distance);
    }
    EXPECT_GE(found.bound, largest);
    EXPECT_GE(found.distance, largest * (1.0 - 1e-3));
    EXPECT_LE(found.bound, found.distance * (1.0 + 1e-3) + 1e-12);
    EXPECT_NEAR(closestOnMesh(mesh, found.point).distance, found.distance, 1e-12);
    EXPECT_NEAR(closestOnMesh(from, found.point).distance, 0.0, 1e-12);
  }
}

// Equal surfaces in other triangles: nothing is farther than rounding.
TEST(FarthestPoint, OfTheSameSurfaceIsOnIt)
{
  const TriangleMesh mesh = icosphere(1.0, 2);
  const FarthestPoint found = PointDistance(mesh).farthest(subdivided(mesh, 2));
  EXPECT_LT(found.distance, 1e-12);
  EXPECT_LT(found.bound, 1e-5);
}

TEST(FarthestPoint, RefusesAToleranceThatIsNone)
{
  const PointDistance query(box({ 1.0, 1.0, 1.0 }));
  EXPECT_THROW(query.farthest(box({ 1.0, 1.0, 1.0 }), 0.0), Error);
  EXPECT_THROW(query.farthest(box({ 1.0, 1.0, 1.0 }), std::nan("")), Error);
  EXPECT_THROW(query.farthest({}), Error);
}
