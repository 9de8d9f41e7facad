#include "sign/rim.h"

#include "base/disjoint_sets.h"

#include <algorithm>
#include <unordered_map>

namespace medial
{
namespace
{

constexpr int kNone = -1;

/// Numbers the points of a rim from 0 in the order in which they appear.
class RimPoints
{
public:
  int operator()(int point)
  {
    return numbers_.try_emplace(point, static_cast<int>(numbers_.size())).first->second;
  }
  std::size_t size() const { return numbers_.size(); }

private:
  std::unordered_map<int, int> numbers_;
};

/// Splits a rim into loops without a point that is there twice. As many edges lead to a point as
/// away from it.
class LoopFinder
{
public:
  explicit LoopFinder(const std::vector<RimEdge>& rim)
    : rim_(rim)
  {
    RimPoints number;
    for (const RimEdge& edge : rim)
    {
      from_.push_back(number(edge.from));
      to_.push_back(number(edge.to));
      left_.push_back(edge.weight);
    }
    leaving_.resize(number.size());
    for (std::size_t edge = 0; edge < rim.size(); ++edge)
    {
      leaving_[from_[edge]].push_back(static_cast<int>(edge));
    }
    place_.assign(number.size(), kNone);
  }

  /// Calls visit() with the points of every loop and how often it counts.
  template <typename Visit>
  void visitLoops(const Visit& visit)
  {
    for (std::size_t edge = 0; edge < rim_.size(); ++edge)
    {
      while (left_[edge] > 0)
      {
        this->walk(from_[edge], visit);
      }
    }
  }

private:
  /// Walks from a point until no edge is left there, and takes out the loops on the way.
  template <typename Visit>
  void walk(int point, const Visit& visit)
  {
    place_[point] = 0;
    for (int edge = this->next(point); edge != kNone; edge = this->next(point))
    {
      path_.push_back(edge);
      point = to_[edge];
      if (place_[point] == kNone)
      {
        place_[point] = static_cast<int>(path_.size());
      }
      else
      {
        this->takeLoop(place_[point], visit);
      }
    }
    place_[point] = kNone;
  }

  int next(int point)
  {
    std::vector<int>& edges = leaving_[point];
    while (!edges.empty() && left_[edges.back()] == 0)
    {
      edges.pop_back();
    }
    return edges.empty() ? kNone : edges.back();
  }

  /// Takes the end of the path out as a loop.
  template <typename Visit>
  void takeLoop(int begin, const Visit& visit)
  {
    const auto first = path_.begin() + begin;
    const int weight = left_[*std::min_element(first, path_.end(),
      [this](int a, int b) { return left_[a] < left_[b]; })];
    std::vector<int> points;
    std::for_each(first, path_.end(),
      [&](int edge)
      {
        left_[edge] -= weight;
        points.push_back(rim_[edge].from);
        if (edge != *first)
        {
          place_[from_[edge]] = kNone;
        }
      });
    visit(points, weight);
    path_.erase(first, path_.end());
  }

  const std::vector<RimEdge>& rim_;
  std::vector<int> from_; ///< numbers of points
  std::vector<int> to_;
  std::vector<int> left_; ///< per edge: how often it is left
  std::vector<std::vector<int>> leaving_;
  std::vector<int> path_;  ///< edges
  std::vector<int> place_; ///< per point: how many edges of the path lead to it
};

/// Closes a piece of a loop by the edge between its ends.
/// @param end place of the last point; after the last of the loop comes the first.
void closePiece(const std::vector<int>& loop, std::size_t begin, std::size_t end, int weight,
  std::vector<WeightedTriangle>& lids)
{
  if (end - begin < 2)
  {
    return;
  }
  const std::size_t middle = begin + (end - begin) / 2;
  if (end - begin < loop.size())
  {
    lids.push_back({ { loop[end % loop.size()], loop[middle], loop[begin] }, weight });
  }
  closePiece(loop, begin, middle, weight, lids);
  closePiece(loop, middle, end, weight, lids);
}

} // namespace

std::vector<WeightedTriangle> lidsOf(const std::vector<RimEdge>& rim)
{
  std::vector<WeightedTriangle> lids;
  LoopFinder(rim).visitLoops([&](const std::vector<int>& loop, int weight)
    { closePiece(loop, 0, loop.size(), weight, lids); });
  return lids;
}

std::int64_t countHoles(const std::vector<RimEdge>& rim)
{
  RimPoints number;
  DisjointSets pieces(2 * rim.size());
  std::int64_t holes = 0;
  for (const RimEdge& edge : rim)
  {
    const auto known = static_cast<std::int64_t>(number.size());
    const int from = number(edge.from);
    const bool joined = pieces.join(from, number(edge.to));
    holes += static_cast<std::int64_t>(number.size()) - known - (joined ? 1 : 0);
  }
  return holes;
}

} // namespace medial
