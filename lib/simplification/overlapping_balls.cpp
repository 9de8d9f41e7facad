#include "simplification/overlapping_balls.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace medial
{
namespace
{

constexpr double kNever = std::numeric_limits<double>::infinity();
constexpr int kSeveral = -1;
/// Balls on opposite sides of a surface only touch. Balls overlap if they do so by more than this
/// share of the smaller radius.
constexpr double kMinOverlap = 0.05;

bool overlap(const Ball& a, const Ball& b, double distance)
{
  return distance < a.radius + b.radius - kMinOverlap * std::min(a.radius, b.radius);
}

std::vector<ItemBounds> boundsOf(const std::vector<Ball>& balls)
{
  std::vector<ItemBounds> bounds(balls.size(), ItemBounds::nothing());
  for (std::size_t i = 0; i < balls.size(); ++i)
  {
    bounds[i].add(balls[i].centre, balls[i].radius);
  }
  return bounds;
}

} // namespace

OverlappingBalls::OverlappingBalls(const std::vector<Ball>& balls)
  : balls_(balls)
  , tree_(boundsOf(balls))
{
  this->setGroups(std::vector<int>(balls.size(), 0));
}

void OverlappingBalls::setGroups(const std::vector<int>& groups)
{
  groups_ = groups;
  groupOfNode_ = tree_.valuesOfNodes<int>([this](std::uint32_t ball) { return groups_[ball]; },
    [](int a, int b) { return a == b ? a : kSeveral; });
}

std::optional<OverlappingBalls::Neighbour> OverlappingBalls::nearest(const Ball& ball, int group,
  double limit) const
{
  const auto minDistance = [&](std::uint32_t node)
  {
    const ItemBounds& bounds = tree_.bounds(node);
    const double distance = bounds.minCentreDistance(ball.centre);
    const bool possible = groupOfNode_[node] != group && distance < ball.radius + bounds.reach;
    return possible ? distance : kNever;
  };
  std::optional<Neighbour> best;
  // Centres exactly at the limit count, too.
  double beyond = std::nextafter(limit, kNever);
  tree_.searchNodes(minDistance, beyond,
    [&](std::uint32_t item)
    {
      const int other = static_cast<int>(item);
      const double distance = glm::distance(ball.centre, balls_[other].centre);
      const bool nearer = distance < limit || (distance == limit && (!best || other < best->ball));
      if (groups_[other] != group && nearer && overlap(ball, balls_[other], distance))
      {
        best = { other, distance };
        limit = distance;
        beyond = std::nextafter(distance, kNever);
      }
    });
  return best;
}

} // namespace medial
