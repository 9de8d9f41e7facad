#include "simplification/model_distance.h"

#include "balls/ball_hulls.h"

#include <algorithm>

namespace medial
{
namespace
{

/// Points farther away than this (radii) may have their nearest cell around a neighbour.
constexpr double kFar = 0.01;

} // namespace

int NearestCell::mainVertex() const
{
  return corners[std::max_element(shares.begin(), shares.end()) - shares.begin()];
}

ModelDistance::ModelDistance(const BallComplex& complex, const std::vector<Ball>& balls)
  : complex_(complex)
  , balls_(balls)
{
}

NearestCell ModelDistance::nearest(const glm::dvec3& point, int vertex) const
{
  NearestCell best = this->nearestAround(point, vertex);
  while (best.mainVertex() != vertex)
  {
    vertex = best.mainVertex();
    const NearestCell next = this->nearestAround(point, vertex);
    if (!(next.distance < best.distance))
    {
      break;
    }
    best = next;
  }
  if (best.distance > kFar * balls_[vertex].radius)
  {
    for (const int edge : complex_.edgesOf(vertex))
    {
      const NearestCell next = this->nearestAround(point, complex_.across(edge, vertex));
      best = next.distance < best.distance ? next : best;
    }
  }
  return best;
}

NearestCell ModelDistance::nearestAround(const glm::dvec3& point, int vertex) const
{
  NearestCell best = this->cellOf(point, { vertex, vertex, vertex }, { 1.0, 0.0, 0.0 });
  const auto compare = [&best](const NearestCell& cell)
  { best = cell.distance < best.distance ? cell : best; };
  for (const int edge : complex_.edgesOf(vertex))
  {
    const auto [a, b] = complex_.edge(edge);
    const auto shares = nearestShares(balls_[a], balls_[b], point);
    compare(this->cellOf(point, { a, b, b }, { shares[0], shares[1], 0.0 }));
  }
  for (const int triangle : complex_.trianglesOf(vertex))
  {
    const std::array<int, 3>& corners = complex_.triangle(triangle);
    const auto shares =
      nearestShares(balls_[corners[0]], balls_[corners[1]], balls_[corners[2]], point);
    if (shares)
    {
      compare(this->cellOf(point, corners, *shares));
    }
  }
  return best;
}

NearestCell ModelDistance::cellOf(const glm::dvec3& point, const std::array<int, 3>& corners,
  const std::array<double, 3>& shares) const
{
  glm::dvec4 mean(0.0);
  for (int k = 0; k < 3; ++k)
  {
    mean += shares[k] * toVector(balls_[corners[k]]);
  }
  const Ball ball = toBall(mean);
  const glm::dvec3 offset = point - ball.centre;
  const double length = glm::length(offset);
  NearestCell cell;
  cell.corners = corners;
  cell.shares = shares;
  cell.distance = length - ball.radius;
  cell.direction = length > 0.0 ? offset / length : glm::dvec3(0.0);
  return cell;
}

} // namespace medial
