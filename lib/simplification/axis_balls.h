#pragma once

#include "balls/ball.h"
#include "medial/medial_axis.h"
#include "simplification/ball_complex.h"

#include <array>
#include <vector>

namespace medial
{

/// The balls of an axis in coordinates of their own. The origin is the middle of the bounds of the
/// centres; the unit is the diagonal of these bounds, or the largest radius if that is larger.
struct AxisBalls
{
  Point3 origin; ///< world coordinates
  double unit;   ///< world units
  std::vector<Ball> balls;

  glm::dvec3 toLocal(const Point3& world) const;
  glm::dvec3 toLocal(const std::array<float, 3>& world) const;
  Point3 toWorld(const glm::dvec3& local) const;
};

/// Returns the balls of an axis.
/// @throws Error InvalidInput for numbers that are not finite, negative radii, and arrays whose
///   size is neither that of the points nor 0 (radii may not be empty).
AxisBalls ballsOf(const MedialAxis& axis);

/// The two closest surface points of a point of an axis, in the coordinates of its balls.
using ClosestPair = std::array<glm::dvec3, 2>;

/// Returns the closest pairs of an axis, in the coordinates of its balls; nothing if it has none.
std::vector<ClosestPair> closestPairsOf(const MedialAxis& axis, const AxisBalls& frame);

/// Returns the cells of an axis. Quads are split along the diagonal that is shorter in R^4.
/// @throws Error InvalidInput for point ids out of range.
BallComplex complexOf(const MedialAxis& axis, const std::vector<Ball>& balls);

} // namespace medial
