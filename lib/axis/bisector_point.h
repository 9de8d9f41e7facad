#pragma once

#include "base/separation_angle.h"
#include "sites/closest_point.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <vector>

namespace medial
{

/// A point with its closest pair; local coordinates.
struct BisectorPoint
{
  glm::dvec3 position{ 0.0 };
  SitePoint a;
  SitePoint b;

  double radius() const { return glm::distance(position, a.point); }
  /// Half the distance between the closest pair: radius * sin(separation angle / 2).
  double lambda() const { return 0.5 * glm::distance(a.point, b.point); }
  /// Radians.
  double separationAngle() const { return medial::separationAngle(position, a.point, b.point); }
  /// Whether the separation angle is as large as a limit.
  bool reaches(const AngleLimit& limit) const
  {
    return limit.isReached(position, a.point, b.point);
  }
  /// Unit normal of the bisector; zero if both closest points are the same.
  glm::dvec3 normal() const
  {
    const glm::dvec3 across = b.point - a.point;
    const double length = glm::length(across);
    return length > 0.0 ? across / length : glm::dvec3(0.0);
  }
};

} // namespace medial
