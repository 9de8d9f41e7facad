#include "proximity/solid_query.h"

#include "proximity/exact_sign.h"
#include "sign/closed_surface.h"

#include <array>

namespace medial
{
namespace
{

/// The part of a box's shadow along x that lies before a position.
bool meetsLineBefore(const Box& box, const glm::dvec3& x)
{
  return box.min.x <= x.x && box.min.y <= x.y && x.y <= box.max.y && box.min.z <= x.z &&
    x.z <= box.max.z;
}

/// Returns whether the line along x through a position passes through a triangle that faces
/// outwards: 1 into the solid, -1 out of it, 0 not at all. Exact; a line through an edge or a
/// corner counts as one that is moved a little, so that it passes through one of the neighbours.
int directionThrough(const std::array<glm::dvec3, 3>& corners, const glm::dvec3& x)
{
  const auto shadow = [](const glm::dvec3& p) { return glm::dvec2(p.y, p.z); };
  int up = 0; // on which side of x edges are that run upwards, or downwards
  int down = 0;
  for (int i = 0; i < 3; ++i)
  {
    const glm::dvec3& p = corners[i];
    const glm::dvec3& q = corners[(i + 1) % 3];
    const bool rises = p.z < x.z;
    if (rises == (q.z < x.z))
    {
      continue;
    }
    // The same order for both triangles at an edge.
    const int side = rises ? orientation(shadow(p), shadow(q), shadow(x))
                           : orientation(shadow(q), shadow(p), shadow(x));
    (rises ? up : down) = side > 0 ? 1 : -1;
  }
  return up == down ? 0 : -up;
}

} // namespace

SolidQuery::OpenSolid::OpenSolid(const MovingMesh& mesh)
  : local(LocalCoordinates::around(mesh.mesh().bounds(), 0.0))
  , winding(chainOf(mesh.mesh(), mesh.orientation(), local))
{
}

void SolidQuery::update()
{
  if (!mesh_.closed() && !mesh_.mesh().triangles.empty())
  {
    open_ = std::make_unique<OpenSolid>(mesh_);
  }
}

Place SolidQuery::placeOf(const glm::dvec3& x) const
{
  if (mesh_.closed())
  {
    return mesh_.tree().box().contains(x) && this->windingNumber(x) > 0 ? Place::Inside
                                                                        : Place::Outside;
  }
  if (open_ == nullptr)
  {
    return Place::Outside;
  }
  constexpr double kLow = 0.25;
  constexpr double kHigh = 0.75;
  constexpr double kTolerance = 1e-3;
  const Interval value = open_->winding.bounds(open_->local.toLocal({ x.x, x.y, x.z }), kTolerance);
  const double middle = 0.5 * (value.low + value.high);
  return middle < kLow ? Place::Outside : (middle > kHigh ? Place::Inside : Place::Undefined);
}

int SolidQuery::windingNumber(const glm::dvec3& x) const
{
  int sum = 0;
  mesh_.tree().visitLeaves([&](const Box& box) { return meetsLineBefore(box, x); },
    [&](const BoxTree::Node& leaf) { sum += this->crossingsBefore(leaf, x); });
  return sum;
}

int SolidQuery::crossingsBefore(const BoxTree::Node& leaf, const glm::dvec3& x) const
{
  int sum = 0;
  for (int slot = leaf.first; slot < leaf.first + leaf.count; ++slot)
  {
    const int weight = mesh_.weight(slot);
    if (weight == 0)
    {
      continue;
    }
    const std::array<glm::dvec3, 3> corners = mesh_.element(slot).corners;
    const int direction = directionThrough(corners, x);
    // The line has come through where it comes in if x is behind the triangle, and where it goes
    // out if x is before it.
    if (direction != 0 && orientation(corners[0], corners[1], corners[2], x) == direction)
    {
      sum += direction * weight;
    }
  }
  return sum;
}

} // namespace medial
