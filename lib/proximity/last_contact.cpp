#include "proximity/last_contact.h"

#include "proximity/pair_walk.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace medial
{
namespace
{

/// A direction, and how far boxes move along it before they have passed others.
class Movement
{
public:
  explicit Movement(const glm::dvec3& direction)
    : direction_(direction)
    , inverse_(1.0 / direction)
  {
  }

  /// Returns how far a box moves before it has passed another; negative if it never meets it.
  double passing(const Box& a, const Box& b) const
  {
    double begin = 0.0;
    double end = std::numeric_limits<double>::infinity();
    for (int axis = 0; axis < 3; ++axis)
    {
      const double low = b.min[axis] - a.max[axis];
      const double high = b.max[axis] - a.min[axis];
      if (direction_[axis] == 0.0)
      {
        end = low > 0.0 || high < 0.0 ? -1.0 : end;
        continue;
      }
      const double x = low * inverse_[axis];
      const double y = high * inverse_[axis];
      begin = larger(begin, smaller(x, y));
      end = smaller(end, larger(x, y));
    }
    return begin <= end * Box::kRoundedUp ? end * Box::kRoundedUp : -1.0;
  }

private:
  glm::dvec3 direction_;
  glm::dvec3 inverse_;
};

class Search
{
public:
  Search(const MovingMesh& a, const MovingMesh& b, const glm::dvec3& direction, double limit)
    : a_(a)
    , b_(b)
    , direction_(direction)
    , movement_(direction)
    , limit_(limit)
  {
  }

  LastContact run()
  {
    struct Pending
    {
      int a;
      int b;
      double end;
    };
    const auto& nodesA = a_.tree().nodes();
    const auto& nodesB = b_.tree().nodes();
    std::array<Pending, 4 * 64> stack;
    int count = 0;
    stack[count++] = { 0, 0, movement_.passing(a_.tree().box(), b_.tree().box()) };
    while (count > 0 && last_.distance <= limit_)
    {
      const Pending pair = stack[--count];
      if (pair.end <= last_.distance)
      {
        continue;
      }
      const BoxTree::Node& nodeA = nodesA[pair.a];
      const BoxTree::Node& nodeB = nodesB[pair.b];
      if (nodeA.leaf() && nodeB.leaf())
      {
        this->tryLeaves(nodeA, nodeB);
        continue;
      }
      const int first = count;
      for (const NodePair& child : PairChildren(a_.tree(), b_.tree(), { pair.a, pair.b, 0.0 }))
      {
        const double end = movement_.passing(nodesA[child.a].box, nodesB[child.b].box);
        if (end > last_.distance)
        {
          stack[count++] = { child.a, child.b, end };
        }
      }
      std::sort(stack.begin() + first, stack.begin() + count,
        [](const Pending& p, const Pending& q) { return p.end < q.end; });
    }
    return last_;
  }

private:
  void tryLeaves(const BoxTree::Node& nodeA, const BoxTree::Node& nodeB)
  {
    for (int i = nodeA.first; i < nodeA.first + nodeA.count; ++i)
    {
      const Box boxA = a_.boxOf(i);
      const Element elementA = a_.element(i);
      for (int k = nodeB.first; k < nodeB.first + nodeB.count; ++k)
      {
        if (movement_.passing(boxA, b_.boxOf(k)) > last_.distance)
        {
          this->tryElements(elementA, b_.element(k));
        }
      }
    }
  }

  void tryElements(const Element& a, const Element& b)
  {
    for (int i = 0; i < 3; ++i)
    {
      this->tryCorner(a.corners[i], b, 1.0);
      this->tryCorner(b.corners[i], a, -1.0);
      for (int k = 0; k < 3; ++k)
      {
        this->tryEdges(a.corners[i], a.corners[(i + 1) % 3] - a.corners[i], b.corners[k],
          b.corners[(k + 1) % 3] - b.corners[k]);
      }
    }
  }

  /// A corner that moves through a triangle. Margins make up for rounding: nothing slips between
  /// neighbours, and what is found too much makes the distance larger, never smaller.
  void tryCorner(const glm::dvec3& corner, const Element& triangle, double sense)
  {
    const glm::dvec3 u = triangle.corners[1] - triangle.corners[0];
    const glm::dvec3 v = triangle.corners[2] - triangle.corners[0];
    const glm::dvec3 normal = glm::cross(u, v);
    const double along = glm::dot(normal, direction_) * sense;
    const double squared = glm::dot(normal, normal);
    if (along * along <= kGrazing * squared)
    {
      return; // the edges tell
    }
    const glm::dvec3 gap = triangle.corners[0] - corner;
    const double distance = glm::dot(normal, gap) / along;
    if (distance <= last_.distance)
    {
      return;
    }
    const glm::dvec3 x = sense * distance * direction_ - gap;
    const double s = glm::dot(glm::cross(x, v), normal) / squared;
    const double t = glm::dot(glm::cross(u, x), normal) / squared;
    if (s >= -kMargin && t >= -kMargin && s + t <= 1.0 + kMargin)
    {
      this->take(distance, normal);
    }
  }

  /// Edges p + s u and q + t v that meet when the first has moved.
  void tryEdges(const glm::dvec3& p, const glm::dvec3& u, const glm::dvec3& q, const glm::dvec3& v)
  {
    const glm::dvec3 normal = glm::cross(u, v);
    const double along = glm::dot(normal, direction_);
    if (along * along <= kGrazing * glm::dot(u, u) * glm::dot(v, v))
    {
      return;
    }
    const glm::dvec3 gap = q - p;
    const double distance = glm::dot(normal, gap) / along;
    if (distance <= last_.distance)
    {
      return;
    }
    const double s = glm::dot(glm::cross(gap, v), direction_) / along;
    const double t = glm::dot(glm::cross(gap, u), direction_) / along;
    if (s >= -kMargin && s <= 1.0 + kMargin && t >= -kMargin && t <= 1.0 + kMargin)
    {
      this->take(distance, normal);
    }
  }

  void take(double distance, const glm::dvec3& normal)
  {
    const glm::dvec3 unit = glm::normalize(normal);
    last_ = { distance, glm::dot(unit, direction_) < 0.0 ? -unit : unit };
  }

  static constexpr double kGrazing = 1e-24;
  static constexpr double kMargin = 1e-9;

  const MovingMesh& a_;
  const MovingMesh& b_;
  glm::dvec3 direction_;
  Movement movement_;
  double limit_;
  LastContact last_;
};

} // namespace

LastContact lastContact(const MovingMesh& a, const MovingMesh& b, const glm::dvec3& direction,
  double limit)
{
  return Search(a, b, direction, limit).run();
}

} // namespace medial
