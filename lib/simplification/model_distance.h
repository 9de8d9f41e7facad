#pragma once

#include "balls/ball.h"
#include "simplification/ball_complex.h"

#include <glm/glm.hpp>

#include <array>
#include <vector>

namespace medial
{

/// The ball of the medial model whose surface is nearest to a point, as a convex combination of the
/// balls of a cell.
struct NearestCell
{
  std::array<int, 3> corners{ 0, 0, 0 };
  std::array<double, 3> shares{ 0.0, 0.0, 0.0 };
  double distance = 0.0;       ///< of the point from the ball's surface, negative inside
  glm::dvec3 direction{ 0.0 }; ///< unit vector from the ball's centre to the point

  /// Returns the corner with the largest share.
  int mainVertex() const;
};

/// Distances from points to balls, cones and wedges near a vertex.
class ModelDistance
{
public:
  ModelDistance(const BallComplex& complex, const std::vector<Ball>& balls);

  /// Among the cells around `vertex`, and around what they lead to.
  NearestCell nearest(const glm::dvec3& point, int vertex) const;

private:
  NearestCell nearestAround(const glm::dvec3& point, int vertex) const;
  NearestCell cellOf(const glm::dvec3& point, const std::array<int, 3>& corners,
    const std::array<double, 3>& shares) const;

  const BallComplex& complex_;
  const std::vector<Ball>& balls_;
};

} // namespace medial
