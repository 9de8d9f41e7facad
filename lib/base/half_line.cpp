#include "base/half_line.h"

#include <algorithm>
#include <limits>

namespace medial
{

bool HalfLine::meets(const Box& box, double distance) const
{
  const glm::dvec3 x = (box.min - fromLow_) * inverse_;
  const glm::dvec3 y = (box.max - fromHigh_) * inverse_;
  const glm::dvec3 in = glm::min(x, y);
  const glm::dvec3 out = glm::max(x, y);
  // Not a number where the line runs in a side of the box: that counts as meeting it.
  const double begin = std::max({ 0.0, in.x, in.y, in.z });
  const double end = std::min({ distance, out.x, out.y, out.z });
  return !(begin > end);
}

// Möller and Trumbore 1997.
double HalfLine::distanceTo(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c,
  double margin) const
{
  constexpr double kNone = std::numeric_limits<double>::infinity();
  const glm::dvec3 u = b - a;
  const glm::dvec3 v = c - a;
  const glm::dvec3 p = glm::cross(direction_, v);
  const double determinant = glm::dot(u, p);
  if (determinant == 0.0)
  {
    return kNone;
  }
  const glm::dvec3 t = from_ - a;
  const double s = glm::dot(t, p) / determinant;
  const glm::dvec3 q = glm::cross(t, u);
  const double r = glm::dot(direction_, q) / determinant;
  const double distance = glm::dot(v, q) / determinant;
  return s >= -margin && r >= -margin && s + r <= 1.0 + margin && distance >= 0.0 ? distance
                                                                                  : kNone;
}

} // namespace medial
