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

/// What a solid is the union of.
struct BallPrimitives
{
  std::vector<Ball> balls;
  /// Wedges, cones, and balls that belong to neither, by indices into balls; -1 for none. Cones and
  /// balls that are part of a wedge are not listed.
  std::vector<std::array<std::int32_t, 3>> primitives;
};

/// Returns the balls, cones and wedges of a model.
/// @param interpolate whether to use balls, cones and wedges; otherwise only the balls.
/// @throws Error as checkMedialModel().
BallPrimitives primitivesOf(const MedialModel& model, bool interpolate);

/// The solid of a medial model, or of balls alone. Several threads may query it at once.
class BallUnion
{
public:
  /// @param interpolate whether to use balls, cones and wedges; otherwise only the balls.
  /// @throws Error as checkMedialModel().
  explicit BallUnion(const MedialModel& model, bool interpolate = true);
  explicit BallUnion(std::vector<Ball> balls);
  explicit BallUnion(BallPrimitives parts);

  const std::vector<Ball>& balls() const { return balls_; }
  /// As BallPrimitives has them.
  const std::vector<std::array<std::int32_t, 3>>& primitives() const { return primitives_; }

  /// Returns the minimum of the signed distances to the primitives. Outside all of them this is the
  /// exact distance to the union. Inside, the surface is at least -distance away, and exactly that
  /// if no other primitive covers the place where the ball touches the surface of its own.
  /// @param limit only smaller distances are searched for; if there is none, the limit is returned.
  HullDistance nearest(const glm::dvec3& x,
    double limit = std::numeric_limits<double>::infinity()) const;

  /// Returns the distance of nearest(), but to the last bit the same whatever the order of the
  /// primitives and however many there are that are farther away: a primitive's own distance does
  /// not depend on what was found before, and no bound exceeds it by rounding.
  double distance(const glm::dvec3& x, double limit) const;

  /// Whether x lies deeper than `depth` inside some primitive, or, for a negative depth, nearer
  /// than -depth to one.
  bool covers(const glm::dvec3& x, double depth) const;

  /// Returns the distance from x to the surface of the union. Outside it is exact. Inside it is the
  /// distance to a point of the surface that is found by moving out of one primitive after the
  /// other: never too small, and exact if the first move arrives.
  /// @param tolerance points this deep inside the union still count as on its surface.
  double distanceToSurface(const glm::dvec3& x, double tolerance) const;

private:
  HullDistance distanceTo(std::uint32_t primitive, const glm::dvec3& x, double limit) const;
  /// Returns where a straight line from y inside the union leaves it.
  glm::dvec3 wayOut(glm::dvec3 y, const glm::dvec3& direction, double tolerance) const;

  std::vector<Ball> balls_;
  std::vector<std::array<std::int32_t, 3>> primitives_;
  BoundingTree tree_;
};

} // namespace medial
