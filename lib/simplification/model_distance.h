#pragma once

#include "simplification/ball_complex.h"
#include "simplification/ball_quadric.h"
#include "simplification/wedge.h"

#include <array>
#include <optional>
#include <vector>

namespace medial
{

/// The ball of the medial model whose boundary is next to a point: a mean of those of a cell.
struct Contact
{
  std::array<int, 3> corners{ 0, 0, 0 };
  std::array<double, 3> shares{ 0.0, 0.0, 0.0 };
  double distance = 0.0;       ///< of the point from the ball's boundary, negative inside
  glm::dvec3 direction{ 0.0 }; ///< unit vector from the ball's centre to the point

  /// The corner of the largest share.
  int mainVertex() const;
};

/// Distances from points to cones and slabs near a vertex.
class ModelDistance
{
public:
  ModelDistance(const BallComplex& complex, const std::vector<Ball>& balls);

  /// Among the cells around `vertex`, and around what they lead to.
  Contact nearest(const glm::dvec3& point, int vertex) const;

private:
  Contact nearestAround(const glm::dvec3& point, int vertex) const;
  Contact ofShares(const glm::dvec3& point, const std::array<int, 3>& corners,
    const std::array<double, 3>& shares) const;
  std::optional<Contact> ofTriangle(const glm::dvec3& point, int triangle) const;
  Contact ofEdge(const glm::dvec3& point, int edge) const;

  const BallComplex& complex_;
  const std::vector<Ball>& balls_;
};

} // namespace medial
