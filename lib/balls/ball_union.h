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

/// The solid of a medial model. Queries may come from several threads at once.
class BallUnion
{
public:
  /// @param interpolate balls, cones and slabs; otherwise the balls only.
  /// @throws Error as checkMedialModel().
  explicit BallUnion(const MedialModel& model, bool interpolate = true);

  const std::vector<Ball>& balls() const { return balls_; }
  /// Slabs, cones and the balls that are in neither, by the numbers of their balls; -1 for none.
  /// Cones and balls that are part of a slab are not listed.
  const std::vector<std::array<std::int32_t, 3>>& primitives() const { return primitives_; }

  /// The primitive with the least signed distance. Outside of all that is the exact distance to the
  /// union; inside, the surface is at least as far as -distance, and just as far where no other
  /// primitive covers the point that the contact names.
  /// @param limit only what is nearer is looked for; where there is nothing, this is the distance.
  Contact contact(const glm::dvec3& x,
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
  Contact contactWith(std::uint32_t primitive, const glm::dvec3& x, double limit) const;

  std::vector<Ball> balls_;
  std::vector<std::array<std::int32_t, 3>> primitives_;
  BoundingTree tree_;
};

} // namespace medial
