#pragma once

#include <glm/glm.hpp>

#include <vector>

namespace medial
{

/// A directed edge where the triangles of a surface, as they count, do not cancel out.
struct RimEdge
{
  int from;
  int to;
  int weight; ///< how often the triangles run from `from` to `to`, > 0
};

/// A cone over a connected piece of a rim, which closes a hole.
struct Lid
{
  glm::dvec3 tip; ///< the middle of the piece's points
  std::vector<RimEdge> rim;
};

/// Closes the holes of a surface, one lid for each connected piece of the rim.
/// @param points of the surface, by the ids of the rim's edges.
std::vector<Lid> lidsOf(const std::vector<RimEdge>& rim, const std::vector<glm::dvec3>& points);

} // namespace medial
