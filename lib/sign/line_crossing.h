#pragma once

#include <glm/glm.hpp>

#include <array>
#include <optional>

namespace medial
{

/// What remains of a triangle in a plane of constant z: a segment with a direction.
struct SliceSegment
{
  glm::dvec2 from;
  glm::dvec2 to;
};

/// A place where a line along x passes through a triangle.
struct LineCrossing
{
  double x;
  int direction; ///< 1 into the solid, for triangles that face outwards; -1 out of it
};

/// Returns where an edge passes through the plane of constant z, as (x, y). Bit-equal for both
/// directions of the edge.
inline glm::dvec2 crossPlane(const glm::dvec3& p, const glm::dvec3& q, double z)
{
  const glm::dvec3& low = p.z < q.z ? p : q;
  const glm::dvec3& high = p.z < q.z ? q : p;
  const double t = (z - low.z) / (high.z - low.z);
  return glm::dvec2(low) + t * (glm::dvec2(high) - glm::dvec2(low));
}

/// Cuts a triangle with a plane. Points in the plane count as above it, so every plane cuts a
/// closed surface in closed lines: neighbours agree on the ends of their segments to the last bit.
inline std::optional<SliceSegment> cutAt(const std::array<glm::dvec3, 3>& corners, double z)
{
  SliceSegment segment{};
  bool cut = false;
  for (int i = 0; i < 3; ++i)
  {
    const glm::dvec3& p = corners[i];
    const glm::dvec3& q = corners[(i + 1) % 3];
    const bool below = p.z < z;
    if (below != (q.z < z))
    {
      (below ? segment.from : segment.to) = crossPlane(p, q, z);
      cut = true;
    }
  }
  return cut ? std::optional(segment) : std::nullopt;
}

/// Returns where the line of constant y passes through a segment. Points on the line count as above
/// it, so a line passes through closed lines as often inwards as outwards.
inline std::optional<LineCrossing> crossLine(const SliceSegment& segment, double y)
{
  const bool below = segment.from.y < y;
  if (below == (segment.to.y < y))
  {
    return std::nullopt;
  }
  const double t = (y - segment.from.y) / (segment.to.y - segment.from.y);
  return LineCrossing{ segment.from.x + t * (segment.to.x - segment.from.x), below ? 1 : -1 };
}

} // namespace medial
