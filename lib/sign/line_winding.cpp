#include "sign/line_winding.h"

#include "base/exact_sign.h"

#include <utility>

namespace medial
{
namespace
{

/// Returns whether the line along x through a position passes through a triangle that faces
/// outwards: 1 into the solid, -1 out of it, 0 not at all.
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

int crossingBefore(const std::array<glm::dvec3, 3>& corners, const glm::dvec3& x)
{
  const int direction = directionThrough(corners, x);
  // The line has come through where it comes in if x is behind the triangle, and where it goes out
  // if x is before it.
  return direction != 0 && orientation(corners[0], corners[1], corners[2], x) == direction
    ? direction
    : 0;
}

LineWinding::LineWinding(TriangleChain surface)
  : surface_(std::move(surface))
{
  for (glm::dvec3& point : surface_.points)
  {
    point = withoutTinyCoordinates(point);
  }
  if (surface_.triangles.empty())
  {
    return; // a tree has one element at least
  }
  std::vector<glm::ivec3> corners;
  corners.reserve(surface_.triangles.size());
  for (const WeightedTriangle& triangle : surface_.triangles)
  {
    const auto& [a, b, c] = triangle.corners;
    corners.emplace_back(a, b, c);
  }
  tree_.build(surface_.points, corners);
}

int LineWinding::at(const glm::dvec3& position) const
{
  if (surface_.triangles.empty())
  {
    return 0;
  }
  const glm::dvec3 x = withoutTinyCoordinates(position);
  int sum = 0;
  tree_.visitLeaves([&](const Box& box) { return meetsLineBefore(box, x); },
    [&](const BoxTree::Node& leaf)
    {
      for (int slot = leaf.first; slot < leaf.first + leaf.count; ++slot)
      {
        const WeightedTriangle& triangle = surface_.triangles[tree_.elements()[slot]];
        sum += triangle.weight * crossingBefore(surface_.cornersOf(triangle), x);
      }
    });
  return sum;
}

} // namespace medial
