#include "proximity/closest_element.h"

#include "proximity/element_distance.h"

#include <algorithm>
#include <array>
#include <cmath>
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

/// Positions that are searched for together, one in every lane. What the lanes tell of distances is
/// a filter: what may be closest is looked at by tryElement().
class Packet
{
public:
  MEDIAL_INLINE Packet(const MovingMesh& mesh, const glm::dvec3* positions, int count,
    ClosestElement* best)
    : mesh_(mesh)
    , positions_(positions)
    , count_(count)
    , best_(best)
  {
    const Box& box = mesh.tree().box();
    double largest = glm::length(glm::max(glm::abs(box.min), glm::abs(box.max)));
    for (int lane = 0; lane < kDoubleLanes; ++lane)
    {
      const glm::dvec3& x = positions[std::min(lane, count - 1)];
      x_[lane] = x.x;
      y_[lane] = x.y;
      z_[lane] = x.z;
      largest = larger(largest, glm::length(x));
    }
    rounding_ = kRounding * largest;
  }

  MEDIAL_INLINE void tryHints()
  {
    for (int lane = 0; lane < count_; ++lane)
    {
      const int hint = best_[lane].slot;
      best_[lane] = {};
      if (hint >= 0)
      {
        tryElement(mesh_, hint, positions_[lane], best_[lane]);
      }
      this->setLimit(lane);
    }
    for (int lane = count_; lane < kDoubleLanes; ++lane)
    {
      limit_[lane] = -1.0;
    }
  }

  /// Whether a box is near enough to any position.
  MEDIAL_INLINE bool reaches(const Box& box) const
  {
    const Double4 x = max(max(box.min.x - x_, x_ - box.max.x), Double4{});
    const Double4 y = max(max(box.min.y - y_, y_ - box.max.y), Double4{});
    const Double4 z = max(max(box.min.z - z_, z_ - box.max.z), Double4{});
    const Long4 within = x * x + y * y + z * z <= limit_; // Clang takes another type
    return bits(within) != 0;
  }

  MEDIAL_INLINE void visit(const BoxTree::Node& leaf)
  {
    for (int slot = leaf.first; slot < leaf.first + leaf.count; ++slot)
    {
      if (!this->reaches(mesh_.boxOf(slot)))
      {
        continue;
      }
      const Long4 within = this->squaredTo(mesh_.element(slot)) <= limit_;
      unsigned lanes = bits(within);
      for (int lane = 0; lanes != 0; ++lane, lanes >>= 1)
      {
        if ((lanes & 1u) != 0)
        {
          tryElement(mesh_, slot, positions_[lane], best_[lane]);
          this->setLimit(lane);
        }
      }
    }
  }

private:
  /// Rounding of distances, as a share of the coordinates.
  static constexpr double kRounding = 1e-13;

  MEDIAL_INLINE void setLimit(int lane)
  {
    const double distance = std::sqrt(best_[lane].squared) + rounding_;
    limit_[lane] = distance * distance * Box::kRoundedUp;
  }

  /// Squared distances of a line's part p + s u, s in [0, 1].
  MEDIAL_INLINE Double4 squaredToEdge(const glm::dvec3& p, const glm::dvec3& u) const
  {
    const Double4 x = x_ - p.x;
    const Double4 y = y_ - p.y;
    const Double4 z = z_ - p.z;
    const double length = glm::dot(u, u);
    const double inverse = length > 0.0 ? 1.0 / length : 0.0;
    const Double4 s = min(max((x * u.x + y * u.y + z * u.z) * inverse, Double4{}), splat(1.0));
    const Double4 gapX = x - s * u.x;
    const Double4 gapY = y - s * u.y;
    const Double4 gapZ = z - s * u.z;
    return gapX * gapX + gapY * gapY + gapZ * gapZ;
  }

  /// Squared distances to an element, or 0 where rounding may spoil them.
  MEDIAL_INLINE Double4 squaredTo(const Element& element) const
  {
    const auto& [a, b, c] = element.corners;
    const glm::dvec3 along[] = { b - a, c - b, a - c };
    const glm::dvec3 normal = glm::cross(along[0], along[1]);
    const double squared = glm::dot(normal, normal);
    constexpr double kThin = 1e-6;
    const double sides = glm::dot(along[0], along[0]) * glm::dot(along[1], along[1]);
    if (!(squared > kThin * sides))
    {
      return Double4{};
    }
    Double4 toEdges = this->squaredToEdge(a, along[0]);
    toEdges = min(toEdges, this->squaredToEdge(b, along[1]));
    toEdges = min(toEdges, this->squaredToEdge(c, along[2]));
    Long4 above = ~Long4{};
    for (int i = 0; i < 3; ++i)
    {
      const glm::dvec3 inward = glm::cross(normal, along[i]);
      above &= this->heights(inward, element.corners[i]) > 0.0;
    }
    const Double4 height = this->heights(normal, a);
    return above ? height * height / squared : toEdges;
  }

  MEDIAL_INLINE Double4 heights(const glm::dvec3& normal, const glm::dvec3& from) const
  {
    return (x_ - from.x) * normal.x + (y_ - from.y) * normal.y + (z_ - from.z) * normal.z;
  }

  const MovingMesh& mesh_;
  const glm::dvec3* positions_;
  int count_;
  ClosestElement* best_;
  double rounding_ = 0.0;
  Double4 x_{};
  Double4 y_{};
  Double4 z_{};
  Double4 limit_{}; ///< no element farther than this is closest; negative in lanes without position
};

MEDIAL_VECTORISED void searchTogether(const MovingMesh& mesh, const glm::dvec3* positions,
  int count, ClosestElement* found)
{
  Packet packet(mesh, positions, count, found);
  packet.tryHints();
  const auto& nodes = mesh.tree().nodes();
  std::array<int, 64> stack;
  int size = 0;
  stack[size++] = 0;
  while (size > 0)
  {
    const int next = stack[--size];
    const BoxTree::Node& node = nodes[next];
    if (!packet.reaches(node.box))
    {
      continue;
    }
    if (node.leaf())
    {
      packet.visit(node);
      continue;
    }
    int near = next + 1;
    int far = node.second;
    if (nodes[far].box.squaredDistance(positions[0]) <
      nodes[near].box.squaredDistance(positions[0]))
    {
      std::swap(near, far);
    }
    stack[size++] = far;
    stack[size++] = near;
  }
}

} // namespace

void closestElements(const MovingMesh& mesh, const glm::dvec3* positions, int count,
  ClosestElement* found)
{
  searchTogether(mesh, positions, count, found);
}

ClosestElement closestElement(const MovingMesh& mesh, const glm::dvec3& x, int hint)
{
  return search(mesh, x, hint);
}

} // namespace medial
