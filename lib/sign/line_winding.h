#pragma once

#include "base/box_tree.h"
#include "sign/closed_surface.h"

#include <glm/glm.hpp>

#include <array>
#include <vector>

namespace medial
{

/// Returns what a line along x that comes to a position has passed through on its way, for a
/// triangle that faces outwards: 1 if into the solid, -1 if out of it, 0 if not through the
/// triangle. Exact. A line through an edge or a corner counts as one that is moved a little, so
/// that it passes through one of the neighbours.
int crossingBefore(const std::array<glm::dvec3, 3>& corners, const glm::dvec3& x);

/// Whether a line along x that comes to a position may pass through something in a box before.
inline bool meetsLineBefore(const Box& box, const glm::dvec3& x)
{
  return box.min.x <= x.x && box.min.y <= x.y && x.y <= box.max.y && box.min.z <= x.z &&
    x.z <= box.max.z;
}

/// The winding number of a closed surface, exact at every position that is not on the surface: the
/// sum of what a line along x passes through before it comes there. Several threads may query it at
/// once.
class LineWinding
{
public:
  /// @param surface without a rim.
  explicit LineWinding(TriangleChain surface);

  int at(const glm::dvec3& position) const;

private:
  TriangleChain surface_;
  BoxTree tree_;
};

} // namespace medial
