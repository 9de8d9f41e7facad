// Axes whose distances from a shape are known.
#include "medial/axis_measurement.h"

#include "medial/error.h"
#include "support/axes.h"
#include "support/errors.h"
#include "support/recorded_progress.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <string>
#include <vector>

namespace medial::test
{
namespace
{

AxisMeasurement measureOn(const TriangleMesh& mesh, const MedialModel& model,
  const MeasurementOptions& options = {})
{
  return measureAxis(mesh, analyseConnectivity(mesh), model, options);
}

/// Expects that the same surface of a union has been measured.
void expectSameUnion(const AxisMeasurement& result, const AxisMeasurement& expected)
{
  constexpr double kTolerance = 2e-3;
  const auto expectNear = [](double value, double wanted)
  { EXPECT_NEAR(value, wanted, kTolerance * wanted); };
  expectNear(result.unionToSurface.mean, expected.unionToSurface.mean);
  expectNear(static_cast<double>(result.unionToSurface.places),
    static_cast<double>(expected.unionToSurface.places));
}

TEST(AxisMeasurement, SmallerBallInASphere)
{
  // Facets of the icosphere lie inside the sphere by up to 2e-4.
  const AxisMeasurement result = measureOn(icosphere(1.0, 5), ballModel(0.9));
  EXPECT_NEAR(result.hausdorff(), 0.1, 1e-9); // at the points of the mesh
  EXPECT_NEAR(result.surfaceToUnion.max, 0.1, 1e-9);
  EXPECT_NEAR(result.surfaceToUnion.mean, 0.1, 4e-4);
  EXPECT_NEAR(result.unionToSurface.max, 0.1, 4e-4);
  EXPECT_NEAR(result.unionToSurface.mean, 0.1, 4e-4);
  EXPECT_NEAR(result.meanDistance(), 0.1, 4e-4);
  EXPECT_NEAR(result.radiusError.mean, 0.1, 4e-4);
  EXPECT_EQ(result.centresInside, 1);
  EXPECT_TRUE(result.knowsInside);
  EXPECT_EQ(result.counts.components, 1);
  EXPECT_EQ(result.counts.eulerCharacteristic, 1);
}

TEST(AxisMeasurement, LargerBallAroundASphere)
{
  const AxisMeasurement result = measureOn(icosphere(1.0, 5), ballModel(1.25));
  EXPECT_NEAR(result.surfaceToUnion.max, 0.25, 4e-4);
  EXPECT_NEAR(result.surfaceToUnion.mean, 0.25, 4e-4);
  EXPECT_NEAR(result.unionToSurface.mean, 0.25, 4e-4);
  EXPECT_NEAR(result.radiusError.max, 0.25, 4e-4);
}

TEST(AxisMeasurement, SamplesAreAsManyPerAreaOnBothSurfaces)
{
  MeasurementOptions options;
  options.samples = 20000;
  const AxisMeasurement result = measureOn(icosphere(1.0, 4), ballModel(0.5), options);
  EXPECT_EQ(result.surfaceToUnion.places, 20000);
  EXPECT_NEAR(static_cast<double>(result.unionToSurface.places), 5000.0, 30.0);
}

TEST(AxisMeasurement, BallsTooSmallForSamplesCount)
{
  MeasurementOptions options;
  options.samples = 20000;
  // Facets of the icosphere lie inside the sphere by up to 1.2e-3.
  for (const double radius : { 1e-2, 1e-3, 1e-6, 1e-160, 0.0 })
  {
    const AxisMeasurement result = measureOn(icosphere(1.0, 4), ballModel(radius), options);
    EXPECT_NEAR(result.unionToSurface.mean, 1.0 - radius, 1.3e-3) << radius;
    EXPECT_NEAR(result.unionToSurface.max, 1.0 - radius, 1.3e-3) << radius;
    EXPECT_NEAR(result.meanDistance(), 1.0 - radius, 1.3e-3) << radius;
    EXPECT_GE(result.unionToSurface.places, 1) << radius;
  }
}

TEST(AxisMeasurement, ASmallBallBesideALargeOneCountsInTheMaximum)
{
  for (const double radius : { 1e-6, 0.0 })
  {
    MedialModel model = ballModel(1.0);
    model.centres.push_back({ 0, 0, 3 });
    model.radii.push_back(radius);
    const AxisMeasurement result = measureOn(icosphere(1.0, 5), model);
    EXPECT_NEAR(result.unionToSurface.max, 2.0, 1e-5);
    EXPECT_LT(result.unionToSurface.mean, 3e-4); // by area
  }
}

/// A sphere around the origin and, far from it, a small ball, several times in the model.
TEST(AxisMeasurement, EqualBallsCountOnce)
{
  MedialModel model = ballModel(1.0);
  for (int copies = 1; copies <= 3; ++copies)
  {
    model.centres.push_back({ 5, 0, 0 });
    model.radii.push_back(0.5);
    const AxisMeasurement result = measureOn(icosphere(1.0, 5), model);
    // The mean of |x| - 1 over the small sphere is 4 + r^2 / (3 * 5), and its share 1/5 by area.
    EXPECT_NEAR(result.unionToSurface.mean, (4.0 + 0.25 / 15.0) / 5.0, 2e-3) << copies;
    EXPECT_NEAR(result.unionToSurface.max, 4.5, 1e-2);
  }
}

TEST(AxisMeasurement, EqualPointsCountOnce)
{
  MedialModel model;
  model.centres = { { 0, 0, 2 }, { 0, 0, 2 }, { 0, 0, 2 }, { 0, 0, 4 } };
  model.radii.assign(4, 0.0);
  const AxisMeasurement result = measureOn(icosphere(1.0, 5), model);
  EXPECT_EQ(result.unionToSurface.places, 2);
  EXPECT_NEAR(result.unionToSurface.mean, 2.0, 1e-3);
}

/// The same capsule with its cone whole, in halves, or both.
TEST(AxisMeasurement, OverlappingConesCountOnce)
{
  const TriangleMesh ball = icosphere(1.0, 5);
  MedialModel capsule;
  capsule.centres = { { 1, 0, 0 }, { 9, 0, 0 } };
  capsule.radii = { 1.0, 0.6 };
  capsule.lines = { { 0, 1 } };
  const AxisMeasurement expected = measureOn(ball, capsule);
  capsule.centres.push_back({ 5, 0, 0 });
  capsule.radii.push_back(0.8);
  for (const auto& lines :
    { std::vector<std::array<std::int64_t, 2>>{ { 0, 1 }, { 0, 2 }, { 2, 1 } },
      std::vector<std::array<std::int64_t, 2>>{ { 0, 2 }, { 0, 1 } },
      std::vector<std::array<std::int64_t, 2>>{ { 0, 2 }, { 2, 1 } } })
  {
    capsule.lines = lines;
    expectSameUnion(measureOn(ball, capsule), expected);
  }
}

/// A square plate of two wedges, and the same with wedges over parts of it.
TEST(AxisMeasurement, OverlappingWedgesCountOnce)
{
  const TriangleMesh ball = icosphere(1.0, 5);
  MedialModel plate;
  plate.centres = { { 0, 0, 0 }, { 4, 0, 0 }, { 4, 4, 0 }, { 0, 4, 0 } };
  plate.radii.assign(4, 0.25);
  plate.triangles = { { 0, 1, 2 }, { 0, 2, 3 } };
  const AxisMeasurement expected = measureOn(ball, plate);
  plate.centres.push_back({ 2, 2, 0 });
  plate.radii.push_back(0.25);
  plate.triangles.push_back({ 0, 1, 4 });
  plate.triangles.push_back({ 1, 2, 3 });
  plate.triangles.push_back({ 0, 1, 2 });
  expectSameUnion(measureOn(ball, plate), expected);
}

TEST(AxisMeasurement, SegmentsOfNoWidthAreTheirEnds)
{
  MedialModel model = capsuleModel(1.0, 0.0);
  const AxisMeasurement result = measureOn(icosphere(3.0, 5), model);
  EXPECT_EQ(result.unionToSurface.places, 2);
  EXPECT_NEAR(result.unionToSurface.mean, 2.0, 1e-3);
}

TEST(AxisMeasurement, CapsuleIsItsSegment)
{
  const TriangleMesh mesh = uvCapsule(0.5, 1.0, 256);
  const AxisMeasurement result = measureOn(mesh, capsuleModel(1.0, 0.5));
  EXPECT_LT(result.hausdorff(), 2e-4);
  EXPECT_LT(result.radiusError.max, 2e-4);
  // Half of the segment leaves half a unit uncovered at each end.
  const AxisMeasurement half = measureOn(mesh, capsuleModel(0.5, 0.5));
  EXPECT_NEAR(half.surfaceToUnion.max, 0.5, 2e-4);
  EXPECT_LT(half.surfaceToUnion.mean, 0.25);
  // Its ends lie inside the mesh, sqrt(0.5) - 0.5 at most.
  EXPECT_NEAR(half.unionToSurface.max, 0.5, 0.01);
}

TEST(AxisMeasurement, OneDirectionSeesWhatTheOtherDoesNot)
{
  // A spur of radius 0 sticks out of a ball that is exact elsewhere.
  MedialModel spur = ballModel(1.0);
  spur.centres.push_back({ 0, 0, 2 });
  spur.radii.push_back(0.0);
  spur.lines = { { 0, 1 } };
  const AxisMeasurement result = measureOn(icosphere(1.0, 5), spur);
  EXPECT_NEAR(result.unionToSurface.max, 1.0, 0.05);
  EXPECT_EQ(result.hausdorff(), result.unionToSurface.max);
  // The spur's cone covers the top of the ball: the way out from there is along the mesh.
  EXPECT_LT(result.surfaceToUnion.mean, 0.2);
  EXPECT_NEAR(result.radiusError.max, 1.0, 4e-4);
  EXPECT_EQ(result.centresInside, 1);
}

TEST(AxisMeasurement, ReflexEdgesAreNoLongWayOut)
{
  // Two bars that fill an L and reach over its reflex edge by 0.05.
  MedialModel model;
  const double half = 0.05;
  model.centres = { { -0.5, -1, 0 }, { -0.5, 1, 0 }, { -1, -0.5, 0 }, { 1, -0.5, 0 } };
  model.radii.assign(4, 0.5 + half);
  model.lines = { { 0, 1 }, { 2, 3 } };
  const AxisMeasurement result = measureOn(lPrism(1.0, 0.3), model);
  // At the edge (0, 0, z) the nearest places of the surface are on the crease nearby.
  EXPECT_LT(result.surfaceToUnion.max, 0.6);
}

TEST(AxisMeasurement, RadiusErrorsAreThoseOfEveryBall)
{
  const TriangleMesh mesh = box({ 1.0, 0.8, 0.6 });
  MedialModel model;
  model.centres = { { 0, 0, 0 }, { 0.2, 0, 0 }, { 0, 0, 0.9 } };
  model.radii = { 0.6, 0.5, 0.3 };
  const AxisMeasurement result = measureOn(mesh, model);
  EXPECT_NEAR(result.radiusError.max, 0.1, 1e-12);
  EXPECT_NEAR(result.radiusError.mean, 0.1 / 3.0, 1e-12);
  EXPECT_EQ(result.centresInside, 2);
  EXPECT_EQ(result.counts.components, 3);
  EXPECT_NEAR(result.diagonal, 2.0 * std::sqrt(2.0), 1e-12);
}

TEST(AxisMeasurement, FarFromTheOriginAndInwardFacesChangeNothing)
{
  TriangleMesh mesh = icosphere(1.0, 4);
  const AxisMeasurement expected = measureOn(mesh, ballModel(0.9));
  for (auto& triangle : mesh.triangles)
  {
    std::swap(triangle[0], triangle[1]);
  }
  MedialModel model = ballModel(0.9);
  model.centres[0] = { 1e5, -2e5, 3e5 };
  for (Point3& point : mesh.points)
  {
    point = { point[0] + 1e5, point[1] - 2e5, point[2] + 3e5 };
  }
  const AxisMeasurement result = measureOn(mesh, model);
  EXPECT_NEAR(result.hausdorff(), expected.hausdorff(), 1e-8);
  EXPECT_NEAR(result.radiusError.max, expected.radiusError.max, 1e-8);
  EXPECT_EQ(result.centresInside, 1);
}

TEST(AxisMeasurement, AnOpenMeshHasNoInside)
{
  MedialModel model = ballModel(0.25);
  const AxisMeasurement result = measureOn(plates(0.5, 1.0), model);
  EXPECT_FALSE(result.knowsInside);
  EXPECT_EQ(result.centresInside, 0);
  EXPECT_NEAR(result.radiusError.max, 0.0, 1e-12);
}

TEST(AxisMeasurement, ThreadsDoNotChangeTheResult)
{
  MeasurementOptions one;
  one.execution.threads = 1;
  MeasurementOptions two;
  two.execution.threads = 2;
  const TriangleMesh mesh = lPrism(1.0, 0.3);
  MedialModel model = capsuleModel(0.2, 0.3);
  model.centres.push_back({ -0.5, -0.5, 0.0 });
  model.radii.push_back(0.2);
  model.triangles = { { 0, 1, 2 } };
  const AxisMeasurement a = measureOn(mesh, model, one);
  const AxisMeasurement b = measureOn(mesh, model, two);
  EXPECT_EQ(a.surfaceToUnion.mean, b.surfaceToUnion.mean);
  EXPECT_EQ(a.unionToSurface.mean, b.unionToSurface.mean);
  EXPECT_EQ(a.unionToSurface.places, b.unionToSurface.places);
  EXPECT_EQ(a.radiusError.mean, b.radiusError.mean);
}

TEST(AxisMeasurement, RadiiWithoutMeasureTakeNoMoreTime)
{
  MeasurementOptions options;
  options.samples = 10000;
  for (const double radius : { 1e3, 1e9, 1e30 })
  {
    MedialModel model = capsuleModel(0.5, 0.3);
    model.centres.push_back({ radius, 0.0, 0.0 });
    model.radii.push_back(radius);
    model.lines.push_back({ 1, 2 });
    const AxisMeasurement result = measureOn(icosphere(1.0, 3), model, options);
    EXPECT_GT(result.unionToSurface.max, 1.9 * radius);
    EXPECT_LT(result.unionToSurface.max, 2.1 * radius);
    EXPECT_LT(result.unionToSurface.places, 1000000);
  }
}

TEST(AxisMeasurement, VeryFarFromTheOriginItComesToAnEnd)
{
  TriangleMesh mesh = icosphere(1.0, 3);
  MedialModel model = capsuleModel(0.3, 0.6);
  for (auto* points : { &mesh.points, &model.centres })
  {
    for (Point3& point : *points)
    {
      point[0] += 1e10;
    }
  }
  const AxisMeasurement result = measureOn(mesh, model);
  EXPECT_NEAR(result.hausdorff(), 0.4, 0.01);
}

TEST(AxisMeasurement, ReportsProgressAndCanBeCancelled)
{
  RecordedProgress watch;
  MeasurementOptions options;
  options.execution.progress = &watch;
  measureOn(icosphere(1.0, 3), ballModel(0.9), options);
  EXPECT_EQ(watch.last(), 1.0);
  for (const double stopAt : { 0.0, 0.3, 0.8 })
  {
    RecordedProgress stop;
    stop.cancelAt = stopAt;
    options.execution.progress = &stop;
    expectError([&] { measureOn(icosphere(1.0, 3), ballModel(0.9), options); },
      ErrorCode::Cancelled);
  }
}

void expectRefused(
  const std::function<void(TriangleMesh&, MedialModel&, MeasurementOptions&)>& spoil,
  const std::string& words)
{
  TriangleMesh mesh = icosphere(1.0, 1);
  MedialModel model = ballModel(0.9);
  MeasurementOptions options;
  spoil(mesh, model, options);
  expectError([&] { measureOn(mesh, model, options); }, ErrorCode::InvalidInput, words);
}

TEST(AxisMeasurement, RefusesWhatItCannotMeasure)
{
  expectRefused([](auto&, MedialModel& model, auto&) { model = {}; }, "0 points");
  expectRefused([](auto&, MedialModel& model, auto&) { model.radii[0] = -1.0; }, "radius -1");
  expectRefused([](auto&, auto&, MeasurementOptions& options) { options.samples = 999; },
    "number of samples 999 is outside [1000, 100000000]");
  expectRefused([](auto&, auto&, MeasurementOptions& options) { options.execution.threads = -1; },
    "threads -1");
  expectRefused(
    [](TriangleMesh& mesh, auto&, auto&)
    {
      MeshInput input;
      input.points = { { 0, 0, 0 }, { 1, 0, 0 } };
      input.lines.append({ 0, 1 }, 0);
      mesh = buildTriangleMesh(input);
    },
    "area of 0");
}

} // namespace
} // namespace medial::test
