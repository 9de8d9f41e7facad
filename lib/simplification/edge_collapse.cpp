#include "simplification/edge_collapse.h"

#include "balls/common_point.h"
#include "simplification/triangle_shape.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <numeric>
#include <utility>

namespace medial
{
namespace
{

/// Weight of the spread of the merged balls' centres, relative to the squared distances to planes.
/// It makes the shortest edges go first where the boundary is flat.
constexpr double kSpread = 1e-7;
/// Merged balls lie at most this many lengths of their edge from its middle.
constexpr double kReach = 1.5;
constexpr int kStepEvery = 512;

} // namespace

EdgeCollapse::EdgeCollapse(std::vector<Ball>& balls, std::vector<BallQuadric> quadrics,
  BallComplex& complex)
  : balls_(balls)
  , quadrics_(std::move(quadrics))
  , complex_(complex)
  , plans_(complex.edgeCount())
  , mergedInto_(balls.size())
  , left_(complex.vertexCount())
{
  std::iota(mergedInto_.begin(), mergedInto_.end(), 0);
  tbb::parallel_for(0, complex_.edgeCount(), [this](int edge) { this->plan(edge); });
}

void EdgeCollapse::plan(int edge)
{
  const auto [a, b] = complex_.edge(edge);
  const double weightA = quadrics_[a].weight();
  const double weightB = quadrics_[b].weight();
  BallQuadric sum = quadrics_[a];
  sum += quadrics_[b];
  const glm::dvec4 ends[2] = { toVector(balls_[a]), toVector(balls_[b]) };
  const glm::dvec4 middle = 0.5 * (ends[0] + ends[1]);
  const double length = glm::distance(ends[0], ends[1]);
  glm::dvec4 best = sum.minimiser(middle);
  if (!(glm::distance(best, middle) <= kReach * length))
  {
    best = middle;
    for (const glm::dvec4& end : ends)
    {
      best = sum(end) < sum(best) ? end : best;
    }
  }
  const double both = weightA + weightB;
  const double spread = both > 0.0 ? weightA * weightB / both : 0.0;
  Plan& plan = plans_[edge];
  plan.ball = toBall(best);
  plan.cost = sum(best) + kSpread * spread * length * length;
}

void EdgeCollapse::enqueue(int edge)
{
  Plan& plan = plans_[edge];
  plan.refused = false;
  queue_.push({ plan.cost, edge, ++plan.version });
}

int EdgeCollapse::reduceTo(int target, Freedom freedom, const std::function<void(int)>& step)
{
  queue_ = {};
  for (const int edge : complex_.edges())
  {
    this->enqueue(edge);
  }
  while (left_ > target && !queue_.empty())
  {
    const Candidate next = queue_.top();
    queue_.pop();
    if (!complex_.isEdge(next.edge) || plans_[next.edge].version != next.version)
    {
      continue;
    }
    if (!this->allowed(next.edge, freedom))
    {
      plans_[next.edge].refused = true;
      continue;
    }
    this->contract(next.edge);
    if (left_ % kStepEvery == 0)
    {
      step(left_);
    }
  }
  return left_;
}

bool EdgeCollapse::allowed(int edge, Freedom freedom) const
{
  return freedom.close ||
    (this->keepsTopology(edge, freedom.fill) && this->keepsShape(edge, freedom.fold));
}

/// Checks the link condition: common neighbours of both ends, and pairs of them, belong to cells at
/// the edge, or else close a loop of three balls or a hollow among four that the balls may fill.
bool EdgeCollapse::keepsTopology(int edge, bool mayFill) const
{
  const auto filled = [&](std::initializer_list<Ball> balls)
  { return mayFill && haveCommonPoint(balls); };
  const auto [a, b] = complex_.edge(edge);
  const std::vector<int> common = complex_.commonNeighbours(edge);
  for (std::size_t i = 0; i < common.size(); ++i)
  {
    const int c = common[i];
    if (!complex_.hasTriangle(a, b, c) && !filled({ balls_[a], balls_[b], balls_[c] }))
    {
      return false;
    }
    for (std::size_t j = i + 1; j < common.size(); ++j)
    {
      const int d = common[j];
      if (complex_.hasTriangle(a, c, d) && complex_.hasTriangle(b, c, d) &&
        !filled({ balls_[a], balls_[b], balls_[c], balls_[d] }))
      {
        return false;
      }
    }
  }
  return true;
}

bool EdgeCollapse::keepsShape(int edge, bool mayFold) const
{
  for (const int end : complex_.edge(edge))
  {
    for (const int triangle : complex_.trianglesOf(end))
    {
      if (!this->keepsTriangle(complex_.triangle(triangle), edge, mayFold))
      {
        return false;
      }
    }
  }
  return true;
}

bool EdgeCollapse::keepsTriangle(const std::array<int, 3>& corners, int edge, bool mayFold) const
{
  TrianglePoints before{};
  TrianglePoints after{};
  int moved = 0;
  for (int i = 0; i < 3; ++i)
  {
    const auto& ends = complex_.edge(edge);
    const bool moves = corners[i] == ends[0] || corners[i] == ends[1];
    before[i] = balls_[corners[i]].centre;
    after[i] = moves ? plans_[edge].ball.centre : before[i];
    moved += moves ? 1 : 0;
  }
  if (moved == 2)
  {
    return true; // becomes an edge
  }
  return mayFold ? keepsArea(after) : medial::keepsShape(before, after);
}

void EdgeCollapse::contract(int edge)
{
  const auto [a, b] = complex_.edge(edge);
  const Ball ball = plans_[edge].ball;
  const int kept = complex_.contract(edge);
  const int gone = kept == a ? b : a;
  balls_[kept] = ball;
  quadrics_[kept] += quadrics_[gone];
  mergedInto_[gone] = kept;
  --left_;
  for (const int near : complex_.edgesOf(kept))
  {
    this->plan(near);
    this->enqueue(near);
    for (const int far : complex_.edgesOf(complex_.across(near, kept)))
    {
      if (plans_[far].refused)
      {
        this->enqueue(far);
      }
    }
  }
}

std::vector<int> EdgeCollapse::representatives() const
{
  std::vector<int> result = mergedInto_;
  // Vertices merge into lower ones.
  for (int& vertex : result)
  {
    vertex = result[vertex];
  }
  return result;
}

} // namespace medial
