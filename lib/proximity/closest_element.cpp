#include "proximity/closest_element.h"

#include "proximity/element_distance.h"

#include <array>
#include <utility>

namespace medial
{
namespace
{

MEDIAL_INLINE void tryElement(const MovingMesh& mesh, int slot, const glm::dvec3& x,
  ClosestElement& best)
{
  const glm::dvec3 point = closestPoint(mesh.element(slot), x);
  const double squared = glm::dot(point - x, point - x);
  if (squared < best.squared ||
    (squared == best.squared && mesh.elementIn(slot) < mesh.elementIn(best.slot)))
  {
    best = { squared, point, slot };
  }
}

MEDIAL_VECTORISED ClosestElement search(const MovingMesh& mesh, const glm::dvec3& x, int hint)
{
  struct Pending
  {
    int node;
    double squared;
  };
  ClosestElement best;
  if (hint >= 0)
  {
    tryElement(mesh, hint, x, best);
  }
  const auto& nodes = mesh.tree().nodes();
  std::array<Pending, 64> stack;
  int count = 0;
  stack[count++] = { 0, 0.0 };
  while (count > 0)
  {
    const Pending next = stack[--count];
    if (next.squared > best.squared * Box::kRoundedUp)
    {
      continue;
    }
    const BoxTree::Node& node = nodes[next.node];
    if (node.leaf())
    {
      for (int slot = node.first; slot < node.first + node.count; ++slot)
      {
        if (mesh.boxOf(slot).squaredDistance(x) <= best.squared * Box::kRoundedUp)
        {
          tryElement(mesh, slot, x, best);
        }
      }
      continue;
    }
    Pending near{ next.node + 1, nodes[next.node + 1].box.squaredDistance(x) };
    Pending far{ node.second, nodes[node.second].box.squaredDistance(x) };
    if (far.squared < near.squared)
    {
      std::swap(near, far);
    }
    stack[count++] = far;
    stack[count++] = near;
  }
  return best;
}

} // namespace

ClosestElement closestElement(const MovingMesh& mesh, const glm::dvec3& x, int hint)
{
  return search(mesh, x, hint);
}

} // namespace medial
