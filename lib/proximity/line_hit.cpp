#include "proximity/line_hit.h"

#include <algorithm>
#include <limits>

namespace medial
{
namespace
{

/// Whether a half-line meets a box before a distance.
bool meets(const Box& box, const glm::dvec3& from, const glm::dvec3& inverse, double distance)
{
  const glm::dvec3 x = (box.min - from) * inverse;
  const glm::dvec3 y = (box.max - from) * inverse;
  const glm::dvec3 in = glm::min(x, y);
  const glm::dvec3 out = glm::max(x, y);
  // Not a number where the line runs in a side of the box: that counts as meeting it.
  const double begin = std::max({ 0.0, in.x, in.y, in.z });
  const double end = std::min({ distance, out.x, out.y, out.z });
  return !(begin > end);
}

/// Möller and Trumbore 1997.
double hit(const Element& triangle, const glm::dvec3& from, const glm::dvec3& direction)
{
  constexpr double kNone = std::numeric_limits<double>::infinity();
  const glm::dvec3 u = triangle.corners[1] - triangle.corners[0];
  const glm::dvec3 v = triangle.corners[2] - triangle.corners[0];
  const glm::dvec3 p = glm::cross(direction, v);
  const double determinant = glm::dot(u, p);
  if (determinant == 0.0)
  {
    return kNone;
  }
  const glm::dvec3 t = from - triangle.corners[0];
  const double s = glm::dot(t, p) / determinant;
  const glm::dvec3 q = glm::cross(t, u);
  const double r = glm::dot(direction, q) / determinant;
  const double distance = glm::dot(v, q) / determinant;
  return s >= 0.0 && r >= 0.0 && s + r <= 1.0 && distance >= 0.0 ? distance : kNone;
}

} // namespace

double firstHit(const MovingMesh& mesh, const glm::dvec3& from, const glm::dvec3& direction)
{
  const glm::dvec3 inverse = 1.0 / direction;
  double nearest = std::numeric_limits<double>::infinity();
  mesh.tree().visitLeaves([&](const Box& box) { return meets(box, from, inverse, nearest); },
    [&](const BoxTree::Node& leaf)
    {
      for (int slot = leaf.first; slot < leaf.first + leaf.count; ++slot)
      {
        nearest = std::min(nearest, hit(mesh.element(slot), from, direction));
      }
    });
  return nearest;
}

} // namespace medial
