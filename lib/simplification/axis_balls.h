#pragma once

#include "balls/ball.h"
#include "medial/medial_axis.h"
#include "simplification/ball_complex.h"

#include <array>
#include <vector>

namespace medial
{

/// Balls of an axis in coordinates of their own: the origin at the middle of the centres' bounds,
/// the diagonal of these bounds (or the largest radius, if more) the unit.
struct AxisBalls
{
  Point3 origin; ///< world coordinates
  double unit;   ///< world units
  std::vector<Ball> balls;

  glm::dvec3 toLocal(const Point3& world) const;
  glm::dvec3 toLocal(const std::array<float, 3>& world) const;
  Point3 toWorld(const glm::dvec3& local) const;
};

/// @throws Error InvalidInput for numbers that are not finite, negative radii, and arrays whose
///   size is neither that of the points nor, but for radii, 0.
AxisBalls ballsOf(const MedialAxis& axis);

/// The two closest surface points of a point of an axis, in the coordinates of the balls.
using ClosestPair = std::array<glm::dvec3, 2>;

/// The closest pairs of an axis in coordinates of its balls; nothing where it has none.
std::vector<ClosestPair> closestPairsOf(const MedialAxis& axis, const AxisBalls& frame);

/// The cells of an axis; quads are cut along the diagonal that is shorter in R^4.
/// @throws Error InvalidInput for point ids out of range.
BallComplex complexOf(const MedialAxis& axis, const std::vector<Ball>& balls);

} // namespace medial
