#include "simplification/model_distance.h"

#include <algorithm>
#include <cmath>

namespace medial
{
namespace
{

/// Points farther away (radii) may have their nearest cell around a neighbour.
constexpr double kFar = 0.01;

} // namespace

int Contact::mainVertex() const
{
  return corners[std::max_element(shares.begin(), shares.end()) - shares.begin()];
}

ModelDistance::ModelDistance(const BallComplex& complex, const std::vector<Ball>& balls)
  : complex_(complex)
  , balls_(balls)
{
}

Contact ModelDistance::nearest(const glm::dvec3& point, int vertex) const
{
  Contact best = this->nearestAround(point, vertex);
  while (best.mainVertex() != vertex)
  {
    vertex = best.mainVertex();
    const Contact next = this->nearestAround(point, vertex);
    if (!(next.distance < best.distance))
    {
      break;
    }
    best = next;
  }
  if (best.distance > kFar * balls_[vertex].w)
  {
    for (const int edge : complex_.edgesOf(vertex))
    {
      const Contact next = this->nearestAround(point, complex_.across(edge, vertex));
      best = next.distance < best.distance ? next : best;
    }
  }
  return best;
}

Contact ModelDistance::nearestAround(const glm::dvec3& point, int vertex) const
{
  Contact best = this->ofShares(point, { vertex, vertex, vertex }, { 1.0, 0.0, 0.0 });
  for (const int edge : complex_.edgesOf(vertex))
  {
    const Contact contact = this->ofEdge(point, edge);
    best = contact.distance < best.distance ? contact : best;
  }
  for (const int triangle : complex_.trianglesOf(vertex))
  {
    const auto contact = this->ofTriangle(point, triangle);
    best = contact && contact->distance < best.distance ? *contact : best;
  }
  return best;
}

Contact ModelDistance::ofShares(const glm::dvec3& point, const std::array<int, 3>& corners,
  const std::array<double, 3>& shares) const
{
  Ball ball(0.0);
  for (int k = 0; k < 3; ++k)
  {
    ball += shares[k] * balls_[corners[k]];
  }
  Contact contact;
  contact.corners = corners;
  contact.shares = shares;
  const glm::dvec3 offset = point - centreOf(ball);
  const double length = glm::length(offset);
  contact.distance = length - ball.w;
  contact.direction = length > 0.0 ? offset / length : glm::dvec3(0.0);
  return contact;
}

/// The nearest ball lies off the foot of the perpendicular, towards growing radii.
std::optional<Contact> ModelDistance::ofTriangle(const glm::dvec3& point, int triangle) const
{
  const std::array<int, 3>& corners = complex_.triangle(triangle);
  const auto slab = slabOf(balls_[corners[0]], balls_[corners[1]], balls_[corners[2]]);
  if (!slab)
  {
    return std::nullopt;
  }
  const glm::dvec3 a = centreOf(balls_[corners[0]]);
  const glm::dvec3 e = centreOf(balls_[corners[1]]) - a;
  const glm::dvec3 f = centreOf(balls_[corners[2]]) - a;
  const double height = glm::dot(point - a, slab->up);
  const glm::dvec3 d =
    point - a - height * slab->up - slab->slope * (std::abs(height) / slab->sine);
  const double s = glm::dot(glm::cross(d, f), slab->up) / (2.0 * slab->area);
  const double t = glm::dot(glm::cross(e, d), slab->up) / (2.0 * slab->area);
  if (s < 0.0 || t < 0.0 || s + t > 1.0)
  {
    return std::nullopt;
  }
  return this->ofShares(point, corners, { 1.0 - s - t, s, t });
}

Contact ModelDistance::ofEdge(const glm::dvec3& point, int edge) const
{
  const auto [a, b] = complex_.edge(edge);
  const auto cone = coneOf(balls_[a], balls_[b]);
  if (!cone)
  {
    return this->ofShares(point, { balls_[a].w > balls_[b].w ? a : b, a, b }, { 1.0, 0.0, 0.0 });
  }
  const glm::dvec3 d = point - centreOf(balls_[a]);
  const double along = glm::dot(d, cone->axis);
  const double height = glm::length(d - along * cone->axis);
  const double t = (along - cone->slope * height / cone->sine) / cone->length;
  const double share = std::clamp(t, 0.0, 1.0);
  return this->ofShares(point, { a, b, b }, { 1.0 - share, share, 0.0 });
}

} // namespace medial
