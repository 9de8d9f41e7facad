#pragma once

#include "balls/ball_hulls.h"
#include "balls/bounding_tree.h"
#include "medial/medial_model.h"

#include <glm/glm.hpp>

#include <array>
#include <cstdint>
#include <limits>
#include <vector>

namespace medial
{

/// The solid of a medial model, or of balls alone. Queries may come from several threads at once.
class BallUnion
{
public:
  /// @param interpolate balls, cones and wedges; otherwise the balls only.
  /// @throws Error as checkMedialModel().
  explicit BallUnion(const MedialModel& model, bool interpolate = true);
  explicit BallUnion(std::vector<Ball> balls);

  const std::vector<Ball>& balls() const { return balls_; }
  /// Wedges, cones and the balls that are in neither, by the numbers of their balls; -1 for none.
  /// Cones and balls that are part of a wedge are not listed.
  const std::vector<std::array<std::int32_t, 3>>& primitives() const { return primitives_; }

  /// The minimum of the signed distances to the primitives. Outside of all that is the exact
  /// distance to the union; inside, the surface is at least as far as -distance, and just as far
  /// where no other primitive covers the place at which the ball touches the surface of its own.
  /// @param limit only what is nearer is looked for; where there is nothing, this is the distance.
  HullDistance nearest(const glm::dvec3& x,
    double limit = std::numeric_limits<double>::infinity()) const;

  /// Whether some primitive holds x deeper than `depth`, or, where that is negative, is nearer to x
  /// than -depth.
  bool covers(const glm::dvec3& x, double depth) const;

  /// Distance from x to the surface of the union. Exact outside. Inside, the distance to a point of
  /// the surface that is found by moving out of primitive after primitive: never too small, and
  /// exact where the first move arrives.
  /// @param tolerance how deep inside the union a point still counts as on its surface.
  double distanceToSurface(const glm::dvec3& x, double tolerance) const;

private:
  HullDistance distanceTo(std::uint32_t primitive, const glm::dvec3& x, double limit) const;

  std::vector<Ball> balls_;
  std::vector<std::array<std::int32_t, 3>> primitives_;
  BoundingTree tree_;
};

} // namespace medial
