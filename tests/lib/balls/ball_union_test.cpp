// Compares the union of a medial model with all of its primitives; checks samples of its surface.
#include "balls/ball_union.h"
#include "measure/boundary_samples.h"

#include "support/axes.h"
#include "support/brute_force.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace medial::test
{
namespace
{

const double kPi = std::acos(-1.0);

MedialModel randomModel(int balls, int wedges, int cones)
{
  std::mt19937 generator(3);
  std::uniform_real_distribution<double> coordinate(-1.0, 1.0);
  std::uniform_real_distribution<double> radius(0.01, 0.2);
  std::uniform_int_distribution<std::int64_t> id(0, balls - 1);
  MedialModel model;
  for (int i = 0; i < balls; ++i)
  {
    model.centres.push_back(
      { coordinate(generator), coordinate(generator), coordinate(generator) });
    model.radii.push_back(radius(generator));
  }
  for (int i = 0; i < wedges; ++i)
  {
    model.triangles.push_back({ id(generator), id(generator), id(generator) });
  }
  for (int i = 0; i < cones; ++i)
  {
    model.lines.push_back({ id(generator), id(generator) });
  }
  return model;
}

Ball ballOf(const MedialModel& model, std::int64_t i)
{
  const Point3& centre = model.centres[i];
  return { { centre[0], centre[1], centre[2] }, model.radii[i] };
}

double minOfAll(const MedialModel& model, const glm::dvec3& x, bool interpolate)
{
  double min = 1e30;
  for (std::size_t i = 0; i < model.centres.size(); ++i)
  {
    min = std::min(min, distanceToBall(ballOf(model, i), x).distance);
  }
  for (const auto& [a, b, c] : model.triangles)
  {
    const double wedge =
      distanceToWedge(ballOf(model, a), ballOf(model, b), ballOf(model, c), x).distance;
    min = interpolate ? std::min(min, wedge) : min;
  }
  for (const auto& [a, b] : model.lines)
  {
    const double cone = distanceToCone(ballOf(model, a), ballOf(model, b), x).distance;
    min = interpolate ? std::min(min, cone) : min;
  }
  return min;
}

double sampledArea(const MedialModel& model, double areaPerSample)
{
  const BallUnion solid(model);
  return areaPerSample *
    static_cast<double>(boundarySamples(solid, areaPerSample, 1e-9).even.size());
}

TEST(BallUnion, FindsTheMinimumOfAllPrimitives)
{
  const MedialModel model = randomModel(60, 40, 30);
  const std::vector<Point3> points =
    randomPoints({ { -1.5, -1.5, -1.5 }, { 1.5, 1.5, 1.5 } }, 2000, 5);
  for (const bool interpolate : { true, false })
  {
    const BallUnion solid(model, interpolate);
    for (const Point3& p : points)
    {
      const glm::dvec3 x{ p[0], p[1], p[2] };
      const double expected = minOfAll(model, x, interpolate);
      ASSERT_NEAR(solid.nearest(x).distance, expected, 1e-12);
      EXPECT_EQ(solid.nearest(x, expected - 0.01).distance, expected - 0.01);
      EXPECT_EQ(solid.covers(x, 0.02), expected < -0.02);
    }
  }
}

TEST(BallUnion, OfBallsAloneIsThatOfAModelWithoutCells)
{
  const MedialModel model = randomModel(60, 40, 30);
  std::vector<Ball> balls;
  for (std::size_t i = 0; i < model.centres.size(); ++i)
  {
    balls.push_back(ballOf(model, static_cast<std::int64_t>(i)));
  }
  const BallUnion alone(balls);
  const BallUnion expected(model, false);
  for (const Point3& p : randomPoints({ { -1.5, -1.5, -1.5 }, { 1.5, 1.5, 1.5 } }, 500, 8))
  {
    const glm::dvec3 x{ p[0], p[1], p[2] };
    EXPECT_EQ(alone.nearest(x).distance, expected.nearest(x).distance);
    EXPECT_EQ(alone.covers(x, 0.01), expected.covers(x, 0.01));
  }
  EXPECT_FALSE(BallUnion(std::vector<Ball>()).covers({ 0.0, 0.0, 0.0 }, 0.0));
  EXPECT_EQ(BallUnion(std::vector<Ball>()).nearest({ 0.0, 0.0, 0.0 }, 0.25).distance, 0.25);
}

TEST(BallUnion, DistanceToItsSurfaceFromInside)
{
  // Two half-overlapping balls: from the middle the nearest surface is the circle where they meet.
  MedialModel model = ballModel(2.0, { -1.0, 0.0, 0.0 });
  model.centres.push_back({ 1.0, 0.0, 0.0 });
  model.radii.push_back(2.0);
  const BallUnion solid(model);
  EXPECT_GE(solid.distanceToSurface({ 0.0, 1.2, 0.0 }, 1e-9), std::sqrt(3.0) - 1.2);
  EXPECT_LE(solid.distanceToSurface({ 0.0, 1.2, 0.0 }, 1e-9), 1.2 * (std::sqrt(3.0) - 1.2));
  EXPECT_NEAR(solid.distanceToSurface({ 0.0, 1.7, 0.0 }, 1e-9), std::sqrt(3.0) - 1.7, 1e-2);
  EXPECT_NEAR(solid.distanceToSurface({ -1.5, 0.0, 0.0 }, 1e-9), 1.5, 1e-12);
  EXPECT_NEAR(solid.distanceToSurface({ 0.0, 0.0, 5.0 }, 1e-9), std::sqrt(26.0) - 2.0, 1e-12);
  // At a centre all directions are equally good, and none leads astray.
  EXPECT_GE(solid.distanceToSurface({ -1.0, 0.0, 0.0 }, 1e-9), 2.0 - 1e-9);
  EXPECT_LE(solid.distanceToSurface({ -1.0, 0.0, 0.0 }, 1e-9), 4.0);
}

/// In the lens between balls that hardly overlap, the way out of one ball leads into the other.
TEST(BallUnion, NarrowCreasesAreNoLongWayOut)
{
  for (const double overlap : { 1e-1, 1e-2, 1e-3, 1e-4 })
  {
    MedialModel model = ballModel(1.0, { -1.0 + 0.5 * overlap, 0.0, 0.0 });
    model.centres.push_back({ 1.0 - 0.5 * overlap, 0.0, 0.0 });
    model.radii.push_back(1.0);
    const BallUnion solid(model);
    const double rim = std::sqrt(overlap - 0.25 * overlap * overlap);
    for (const double share : { 0.3, 0.6, 0.9 })
    {
      const glm::dvec3 x{ 0.01 * overlap, 0.6 * share * rim, 0.8 * share * rim };
      const double truth = std::hypot(rim - share * rim, x.x);
      EXPECT_GE(solid.distanceToSurface(x, 1e-12), truth - 1e-9);
      EXPECT_LE(solid.distanceToSurface(x, 1e-12), 1.3 * truth);
    }
  }
}

TEST(BallUnion, NeverTooSmallInside)
{
  const MedialModel model = randomModel(60, 40, 30);
  const BallUnion solid(model);
  const auto boundary = boundarySamples(solid, 1e-5, 1e-9).even;
  int inside = 0;
  int exact = 0;
  for (const Point3& p : randomPoints({ { -1, -1, -1 }, { 1, 1, 1 } }, 500, 6))
  {
    const glm::dvec3 x{ p[0], p[1], p[2] };
    const double distance = solid.distanceToSurface(x, 1e-9);
    double truth = 1e30;
    for (const glm::dvec3& y : boundary)
    {
      truth = std::min(truth, glm::distance(x, y));
    }
    ASSERT_GE(distance, truth - 0.005); // between the samples
    inside += solid.nearest(x).distance < 0.0 ? 1 : 0;
    exact += std::abs(distance - truth) < 0.04 ? 1 : 0;
  }
  EXPECT_GT(inside, 125);
  EXPECT_GT(exact, 430); // others are in creases
}

TEST(BoundarySamples, AreOnTheSurface)
{
  const MedialModel model = randomModel(60, 40, 30);
  const BallUnion solid(model);
  const auto samples = boundarySamples(solid, 1e-3, 1e-9);
  ASSERT_GT(samples.even.size(), 5000u);
  EXPECT_GT(samples.ofBalls.size(), 10u);
  for (const auto* points : { &samples.even, &samples.ofBalls })
  {
    for (const glm::dvec3& x : *points)
    {
      ASSERT_NEAR(minOfAll(model, x, true), 0.0, 1e-8);
    }
  }
}

TEST(BoundarySamples, CountAreas)
{
  EXPECT_NEAR(sampledArea(ballModel(0.5, { 0.3, 0.1, 0.2 }), 1e-4), kPi, 2e-3);
  EXPECT_NEAR(sampledArea(capsuleModel(1.0, 0.5), 1e-4), 3.0 * kPi, 0.02);
  // A cone between balls of radii 1 and 0.5 whose centres are 2 apart.
  MedialModel cone = capsuleModel(1.0, 1.0);
  cone.radii[1] = 0.5;
  const double slope = 0.25;
  const double caps = 2.0 * kPi * (1.0 + slope) + 2.0 * kPi * 0.25 * (1.0 - slope);
  const double lateral = kPi * 1.5 * 2.0 * (1.0 - slope * slope);
  EXPECT_NEAR(sampledArea(cone, 1e-4), caps + lateral, 0.02);
  // A plate: two squares, four half cylinders and a ball.
  MedialModel plate;
  plate.centres = { { 0, 0, 0 }, { 2, 0, 0 }, { 2, 2, 0 }, { 0, 2, 0 } };
  plate.radii.assign(4, 0.25);
  plate.quads = { { 0, 1, 2, 3 } };
  EXPECT_NEAR(sampledArea(plate, 1e-4), 8.0 + 8.0 * kPi * 0.25 + 4.0 * kPi * 0.0625, 0.02);
  // Balls without cones, one within the other and two that overlap by half a radius.
  MedialModel balls = ballModel(1.0);
  balls.centres.push_back({ 0.2, 0, 0 });
  balls.radii.push_back(0.5);
  EXPECT_NEAR(sampledArea(balls, 1e-4), 4.0 * kPi, 0.01);
  balls.centres[1] = { 1.0, 0, 0 };
  balls.radii[1] = 1.0;
  EXPECT_NEAR(sampledArea(balls, 1e-4), 2.0 * 4.0 * kPi * 0.75, 0.03);
}

// The surface of a subdivided plate is that of the plate.
TEST(BoundarySamples, SubdivisionChangesNoArea)
{
  constexpr int kCells = 20;
  MedialModel plate;
  for (int j = 0; j <= kCells; ++j)
  {
    for (int i = 0; i <= kCells; ++i)
    {
      plate.centres.push_back({ 2.0 * i / kCells, 2.0 * j / kCells, 0.0 });
    }
  }
  plate.radii.assign(plate.centres.size(), 0.25);
  for (std::int64_t j = 0; j < kCells; ++j)
  {
    for (std::int64_t i = 0; i < kCells; ++i)
    {
      const std::int64_t first = j * (kCells + 1) + i;
      plate.quads.push_back({ first, first + 1, first + kCells + 2, first + kCells + 1 });
    }
  }
  EXPECT_NEAR(sampledArea(plate, 1e-3), 8.0 + 8.0 * kPi * 0.25 + 4.0 * kPi * 0.0625, 0.05);
}

} // namespace
} // namespace medial::test
