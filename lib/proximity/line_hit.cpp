#include "proximity/line_hit.h"

#include "base/half_line.h"

#include <algorithm>
#include <limits>

namespace medial
{

double firstHit(const MovingMesh& mesh, const glm::dvec3& from, const glm::dvec3& direction)
{
  const HalfLine line(from, direction);
  double nearest = std::numeric_limits<double>::infinity();
  mesh.tree().visitLeaves([&](const Box& box) { return line.meets(box, nearest); },
    [&](const BoxTree::Node& leaf)
    {
      for (int slot = leaf.first; slot < leaf.first + leaf.count; ++slot)
      {
        const auto& corners = mesh.element(slot).corners;
        nearest = std::min(nearest, line.distanceTo(corners[0], corners[1], corners[2]));
      }
    });
  return nearest;
}

} // namespace medial
