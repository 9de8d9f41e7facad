// Compares distances to the cells around a vertex with those to the same cones and wedges.
#include "simplification/model_distance.h"

#include "balls/ball_hulls.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace medial::test
{
namespace
{

/// A fan of triangles around vertex 0, and a line out of it.
BallComplex fan()
{
  BallComplex complex(6);
  complex.addTriangle(0, 1, 2);
  complex.addTriangle(0, 2, 3);
  complex.addTriangle(0, 3, 4);
  complex.addEdge(0, 5);
  return complex;
}

std::vector<Ball> ballsOfFan()
{
  return { { { 0.0, 0.0, 0.0 }, 0.3 }, { { 1.0, 0.0, 0.1 }, 0.2 }, { { 0.7, 0.8, 0.0 }, 0.25 },
    { { -0.2, 1.0, 0.2 }, 0.15 }, { { -1.0, 0.3, 0.0 }, 0.3 }, { { 0.1, -1.2, -0.3 }, 0.4 } };
}

double distanceToFan(const std::vector<Ball>& balls, const glm::dvec3& x)
{
  double min = distanceToCone(balls[0], balls[5], x).distance;
  for (const int i : { 1, 2, 3 })
  {
    min = std::min(min, distanceToWedge(balls[0], balls[i], balls[i + 1], x).distance);
  }
  return min;
}

TEST(ModelDistance, IsTheDistanceToConesAndWedges)
{
  const BallComplex complex = fan();
  const std::vector<Ball> balls = ballsOfFan();
  const ModelDistance model(complex, balls);
  std::mt19937 generator(11);
  std::uniform_real_distribution<double> coordinate(-1.5, 1.5);
  for (int i = 0; i < 2000; ++i)
  {
    const glm::dvec3 x(coordinate(generator), coordinate(generator), coordinate(generator));
    const NearestCell cell = model.nearest(x, 0);
    ASSERT_NEAR(cell.distance, distanceToFan(balls, x), 1e-12);
    glm::dvec4 mean(0.0);
    for (int k = 0; k < 3; ++k)
    {
      mean += cell.shares[k] * toVector(balls[cell.corners[k]]);
    }
    ASSERT_NEAR(distanceToBall(toBall(mean), x).distance, cell.distance, 1e-12);
    ASSERT_NEAR(glm::length(cell.direction), 1.0, 1e-12);
  }
}

} // namespace
} // namespace medial::test
