#include "balls/ball_tree.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <utility>

namespace medial
{
namespace
{

constexpr int kLeafSize = 8;
constexpr int kSeveral = -1;
/// Balls on two sides of a surface touch; those that overlap do so by more than this share of the
/// smaller radius.
constexpr double kMinOverlap = 0.05;

bool overlap(const Ball& a, const Ball& b, double distance)
{
  return distance < a.w + b.w - kMinOverlap * std::min(a.w, b.w);
}

} // namespace

BallTree::BallTree(std::vector<Ball> balls)
  : balls_(std::move(balls))
  , order_(balls_.size())
  , groups_(balls_.size(), 0)
{
  std::iota(order_.begin(), order_.end(), 0);
  if (balls_.empty())
  {
    return;
  }
  Node root{};
  root.end = static_cast<int>(balls_.size());
  nodes_.push_back(root);
  for (int node = 0; node < static_cast<int>(nodes_.size()); ++node)
  {
    this->fit(nodes_[node]);
    this->split(node);
  }
}

void BallTree::fit(Node& node) const
{
  constexpr double kFar = std::numeric_limits<double>::infinity();
  node.min = glm::dvec3(kFar);
  node.max = glm::dvec3(-kFar);
  node.radius = 0.0;
  for (int i = node.begin; i < node.end; ++i)
  {
    const Ball& ball = balls_[order_[i]];
    node.min = glm::min(node.min, centreOf(ball));
    node.max = glm::max(node.max, centreOf(ball));
    node.radius = std::max(node.radius, ball.w);
  }
}

void BallTree::split(int node)
{
  Node left = nodes_[node];
  if (left.end - left.begin <= kLeafSize)
  {
    return;
  }
  const glm::dvec3 size = left.max - left.min;
  int axis = size.y > size.x ? 1 : 0;
  axis = size.z > size[axis] ? 2 : axis;
  Node right = left;
  left.end = right.begin = (left.begin + left.end) / 2;
  std::nth_element(order_.begin() + left.begin, order_.begin() + left.end,
    order_.begin() + right.end,
    [&](int a, int b)
    { return std::make_pair(balls_[a][axis], a) < std::make_pair(balls_[b][axis], b); });
  nodes_[node].left = static_cast<int>(nodes_.size());
  nodes_.push_back(left);
  nodes_.push_back(right);
}

void BallTree::setGroups(const std::vector<int>& groups)
{
  groups_ = groups;
  for (auto node = nodes_.rbegin(); node != nodes_.rend(); ++node)
  {
    if (node->left >= 0)
    {
      const int left = nodes_[node->left].group;
      node->group = left == nodes_[node->left + 1].group ? left : kSeveral;
      continue;
    }
    node->group = groups_[order_[node->begin]];
    for (int i = node->begin; i < node->end; ++i)
    {
      node->group = groups_[order_[i]] == node->group ? node->group : kSeveral;
    }
  }
}

double BallTree::distanceTo(const Node& node, const glm::dvec3& point) const
{
  return glm::distance(point, glm::clamp(point, node.min, node.max));
}

bool BallTree::covers(const glm::dvec3& point, double depth) const
{
  return !nodes_.empty() && this->covers(0, point, depth);
}

bool BallTree::covers(int index, const glm::dvec3& point, double depth) const
{
  const Node& node = nodes_[index];
  if (this->distanceTo(node, point) + depth >= node.radius)
  {
    return false;
  }
  if (node.left >= 0)
  {
    const bool leftFirst =
      this->distanceTo(nodes_[node.left], point) <= this->distanceTo(nodes_[node.left + 1], point);
    const int first = leftFirst ? node.left : node.left + 1;
    const int second = leftFirst ? node.left + 1 : node.left;
    return this->covers(first, point, depth) || this->covers(second, point, depth);
  }
  return std::any_of(order_.begin() + node.begin, order_.begin() + node.end,
    [&](int i) { return glm::distance(point, centreOf(balls_[i])) + depth < balls_[i].w; });
}

double BallTree::distance(const glm::dvec3& point, double limit) const
{
  if (!nodes_.empty())
  {
    this->descend(0, point, limit);
  }
  return limit;
}

void BallTree::descend(int index, const glm::dvec3& point, double& best) const
{
  const Node& node = nodes_[index];
  if (this->distanceTo(node, point) >= best)
  {
    return;
  }
  if (node.left >= 0)
  {
    const bool leftFirst =
      this->distanceTo(nodes_[node.left], point) <= this->distanceTo(nodes_[node.left + 1], point);
    this->descend(leftFirst ? node.left : node.left + 1, point, best);
    this->descend(leftFirst ? node.left + 1 : node.left, point, best);
    return;
  }
  for (int i = node.begin; i < node.end; ++i)
  {
    best = std::min(best, glm::distance(point, centreOf(balls_[order_[i]])));
  }
}

std::optional<BallTree::Neighbour> BallTree::nearestOverlapping(const Ball& ball, int group,
  double limit) const
{
  std::optional<Neighbour> best;
  if (!nodes_.empty())
  {
    this->descend(0, ball, group, best, limit);
  }
  return best;
}

void BallTree::descend(int index, const Ball& ball, int group, std::optional<Neighbour>& best,
  double& limit) const
{
  const Node& node = nodes_[index];
  const double min = this->distanceTo(node, centreOf(ball));
  if (node.group == group || min > limit || min >= ball.w + node.radius)
  {
    return;
  }
  if (node.left >= 0)
  {
    const bool leftFirst = this->distanceTo(nodes_[node.left], centreOf(ball)) <=
      this->distanceTo(nodes_[node.left + 1], centreOf(ball));
    this->descend(leftFirst ? node.left : node.left + 1, ball, group, best, limit);
    this->descend(leftFirst ? node.left + 1 : node.left, ball, group, best, limit);
    return;
  }
  for (int i = node.begin; i < node.end; ++i)
  {
    const int other = order_[i];
    const double distance = glm::distance(centreOf(ball), centreOf(balls_[other]));
    const bool nearer = distance < limit || (distance == limit && (!best || other < best->ball));
    if (groups_[other] != group && nearer && overlap(ball, balls_[other], distance))
    {
      best = { other, distance };
      limit = distance;
    }
  }
}

} // namespace medial
