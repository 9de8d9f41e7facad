#pragma once

#include "base/box.h"

#include <glm/glm.hpp>

namespace medial
{

/// What lies from a position in one direction.
class HalfLine
{
public:
  /// @param direction unit vector.
  /// @param margin boxes count as this much larger on each side.
  HalfLine(const glm::dvec3& from, const glm::dvec3& direction, double margin = 0.0)
    : from_(from)
    , direction_(direction)
    , inverse_(1.0 / direction)
    , fromLow_(from + margin)
    , fromHigh_(from - margin)
  {
  }

  const glm::dvec3& from() const { return from_; }
  const glm::dvec3& direction() const { return direction_; }

  /// Whether it meets a box before a distance.
  bool meets(const Box& box, double distance) const;

  /// Returns the distance to a triangle; infinity if it does not meet it or runs in its plane.
  /// @param margin how far outside it may pass, as a share of the triangle. Without one a line
  ///   through an edge may slip through, by rounding.
  double distanceTo(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c,
    double margin = 0.0) const;

private:
  glm::dvec3 from_;
  glm::dvec3 direction_;
  glm::dvec3 inverse_;
  glm::dvec3 fromLow_;  ///< as seen from the lower sides of boxes
  glm::dvec3 fromHigh_; ///< the same of the upper sides
};

} // namespace medial
