#include "skeleton/open_loops.h"

#include "base/disjoint_sets.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <iterator>
#include <queue>
#include <set>
#include <unordered_map>
#include <unordered_set>
#include <utility>
#include <vector>

namespace medial
{
namespace
{

/// Whether an edge of a curve is outside the solid somewhere.
bool leavesSolid(const NetworkEdge& edge, const NetworkInput& input)
{
  const bool forward = input.radii[edge.ends[0]] >= input.radii[edge.ends[1]];
  const std::int64_t from = edge.ends[forward ? 0 : 1];
  const glm::dvec3& a = input.positions[from];
  const glm::dvec3& b = input.positions[edge.ends[forward ? 1 : 0]];
  const double length = glm::distance(a, b);
  // A point with this radius has no surface between itself and the other end.
  return input.radii[from] <= length && length > 0.0 &&
    input.probe.wayOut(a, (b - a) / length, length) < length;
}

/// Some edges that leave the solid and meet each other, and where they come back into it.
struct Crossing
{
  std::vector<int> edges;
  std::vector<std::int64_t> banks; ///< points that other edges lead to
};

class LoopOpener
{
public:
  LoopOpener(CurveGraph& graph, const NetworkInput& input)
    : graph_(graph)
    , input_(input)
    , leaves_(static_cast<std::size_t>(graph.size()), 0)
  {
  }

  void open()
  {
    tbb::parallel_for(0, graph_.size(),
      [&](int e) { leaves_[e] = graph_.alive(e) && leavesSolid(graph_.edge(e), input_) ? 1 : 0; });
    if (this->closing().empty())
    {
      return;
    }
    for (const Crossing& crossing : this->crossings())
    {
      this->keepDetours(crossing);
    }
    for (const int e : this->closing())
    {
      graph_.remove(e);
    }
  }

private:
  /// Returns the edges that leave the solid and close a loop, each with those before it.
  std::vector<int> closing() const
  {
    std::vector<int> outside;
    DisjointSets pieces(input_.positions.size());
    const auto join = [&](int e)
    { return pieces.join(graph_.edge(e).ends[0], graph_.edge(e).ends[1]); };
    for (int e = 0; e < graph_.size(); ++e)
    {
      if (leaves_[e] != 0)
      {
        outside.push_back(e);
      }
      else if (graph_.alive(e))
      {
        join(e);
      }
    }
    outside.erase(std::remove_if(outside.begin(), outside.end(), join), outside.end());
    return outside;
  }

  std::vector<Crossing> crossings() const
  {
    std::vector<Crossing> result;
    std::vector<char> seen(leaves_.size(), 0);
    for (int first = 0; first < graph_.size(); ++first)
    {
      if (leaves_[first] == 0 || seen[first] != 0)
      {
        continue;
      }
      seen[first] = 1;
      Crossing crossing{ { first }, {} };
      std::set<std::int64_t> banks;
      for (std::size_t i = 0; i < crossing.edges.size(); ++i)
      {
        for (const std::int64_t point : graph_.edge(crossing.edges[i]).ends)
        {
          graph_.find(point,
            [&](int e)
            {
              if (leaves_[e] == 0)
              {
                banks.insert(point);
              }
              else if (seen[e] == 0)
              {
                seen[e] = 1;
                crossing.edges.push_back(e);
              }
              return false;
            });
        }
      }
      crossing.banks.assign(banks.begin(), banks.end());
      result.push_back(std::move(crossing));
    }
    return result;
  }

  /// Makes the ways through a crossing that are detours count as inside.
  void keepDetours(const Crossing& crossing)
  {
    const std::size_t count = crossing.banks.size();
    std::vector<std::vector<std::int64_t>> grounds;
    for (const std::int64_t bank : crossing.banks)
    {
      grounds.push_back(this->around(bank));
    }
    for (std::size_t i = 0; i < count; ++i)
    {
      for (std::size_t j = i + 1; j < count; ++j)
      {
        if (this->joinedByBall(grounds[i], grounds[j]))
        {
          this->keepWay(crossing, crossing.banks[i], crossing.banks[j]);
        }
      }
    }
  }

  /// Points around one, along edges within the solid, up to some radii away from it.
  std::vector<std::int64_t> around(std::int64_t start) const
  {
    constexpr double kReach = 6.0; // in radii
    using Event = std::pair<double, std::int64_t>;
    std::priority_queue<Event, std::vector<Event>, std::greater<>> queue;
    std::set<std::int64_t> reached;
    double widest = 0.0;
    for (queue.emplace(0.0, start); !queue.empty();)
    {
      const auto [length, point] = queue.top();
      queue.pop();
      widest = std::max(widest, input_.radii[point]);
      if (length > kReach * std::max(widest, input_.step))
      {
        break;
      }
      if (!reached.insert(point).second)
      {
        continue;
      }
      graph_.find(point,
        [&, length = length, point = point](int e)
        {
          const std::int64_t next = graph_.otherEnd(e, point);
          if (leaves_[e] == 0 && reached.count(next) == 0)
          {
            queue.emplace(length + glm::distance(input_.positions[point], input_.positions[next]),
              next);
          }
          return false;
        });
    }
    return { reached.begin(), reached.end() };
  }

  /// Whether two parts of a curve are apart, and a ball in the solid holds a point of either.
  bool joinedByBall(const std::vector<std::int64_t>& before,
    const std::vector<std::int64_t>& after) const
  {
    std::vector<std::int64_t> both;
    std::set_intersection(before.begin(), before.end(), after.begin(), after.end(),
      std::back_inserter(both));
    return both.empty() &&
      std::any_of(before.begin(), before.end(),
        [&](std::int64_t a)
        {
          return std::any_of(after.begin(), after.end(),
            [&](std::int64_t b)
            {
              return glm::distance(input_.positions[a], input_.positions[b]) <
                std::max(input_.radii[a], input_.radii[b]);
            });
        });
  }

  /// Lets a way through a crossing, of the fewest edges, count as inside.
  void keepWay(const Crossing& crossing, std::int64_t from, std::int64_t to)
  {
    const std::unordered_set<int> usable(crossing.edges.begin(), crossing.edges.end());
    std::unordered_map<std::int64_t, int> cameBy{ { from, -1 } };
    std::vector<std::int64_t> reached{ from };
    for (std::size_t i = 0; i < reached.size() && cameBy.count(to) == 0; ++i)
    {
      graph_.find(reached[i],
        [&](int e)
        {
          const std::int64_t next = graph_.otherEnd(e, reached[i]);
          if (usable.count(e) != 0 && cameBy.emplace(next, e).second)
          {
            reached.push_back(next);
          }
          return false;
        });
    }
    for (int e = cameBy[to]; e >= 0; e = cameBy[to])
    {
      leaves_[e] = 0;
      to = graph_.otherEnd(e, to);
    }
  }

  CurveGraph& graph_;
  const NetworkInput& input_;
  std::vector<char> leaves_; ///< per edge: whether it leaves the solid
};

} // namespace

void openLoops(CurveGraph& graph, const NetworkInput& input)
{
  LoopOpener(graph, input).open();
}

} // namespace medial
