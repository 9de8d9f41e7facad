#include "skeleton/curve_fire.h"

#include "base/disjoint_sets.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <functional>
#include <iterator>
#include <queue>
#include <set>
#include <tuple>
#include <utility>
#include <vector>

namespace medial
{
namespace
{

/// Edges whose fire arrives this many steps after the sheets have burned belong to curves.
constexpr double kNoise = 3.0;
/// A fire's way along edges is measured by chords over so many of them.
constexpr int kChord = 8;
/// The fire along curves.
class CurveFire
{
public:
  CurveFire(CurveGraph& graph, const NetworkInput& input)
    : graph_(graph)
    , input_(input)
    , fronts_(input.positions.size())
  {
  }

  void burn(const Checkpoint& checkpoint)
  {
    for (int e = 0; e < graph_.size(); ++e)
    {
      for (const std::int64_t end : graph_.edge(e).ends)
      {
        if (graph_.degree(end) == 1)
        {
          fronts_[end] = { input_.positions[end], input_.widths[end], input_.widths[end], 0, -1 };
          this->raise(e, end);
        }
      }
    }
    for (std::size_t events = 0; !queue_.empty(); ++events)
    {
      checkpoint(events);
      const auto [time, e, leaf] = queue_.top();
      queue_.pop();
      if (!graph_.alive(e))
      {
        continue;
      }
      if (time - graph_.edge(e).time > kNoise * input_.step)
      {
        leaves_.push_back(leaf);
        continue; // it stays, and so does everything beyond
      }
      this->advance(e, leaf, time);
    }
    for (const std::int64_t leaf : leaves_)
    {
      this->restore(leaf);
    }
  }

private:
  /// A fire that has come to a point along a curve.
  struct Front
  {
    glm::dvec3 base{ 0.0 };
    double baseTime = 0.0;
    double time = 0.0;
    int sinceBase = 0;
    int edge = -1; ///< the one that it came along
  };
  using Event = std::tuple<double, int, int>; ///< arrival, edge, the end where it is

  double arrival(const Front& front, const glm::dvec3& x) const
  {
    return std::max(front.time, front.baseTime + glm::distance(front.base, x));
  }

  void raise(int e, std::int64_t leaf)
  {
    const std::int64_t next = graph_.otherEnd(e, leaf);
    queue_.emplace(this->arrival(fronts_[leaf], input_.positions[next]), e, static_cast<int>(leaf));
  }

  void advance(int e, std::int64_t leaf, double time)
  {
    graph_.remove(e);
    graph_.drop(leaf);
    const std::int64_t next = graph_.otherEnd(e, leaf);
    Front front = fronts_[leaf];
    front.time = std::max(time, graph_.edge(e).time);
    front.edge = e;
    if (++front.sinceBase == kChord || front.time > time)
    {
      front.base = input_.positions[next];
      front.baseTime = front.time;
      front.sinceBase = 0;
    }
    if (front.time >= fronts_[next].time)
    {
      fronts_[next] = front;
    }
    if (graph_.degree(next) == 1)
    {
      this->raise(graph_.anyEdge(next), next);
    }
  }

  /// Puts back what has burned of a curve that stays, up to its free end.
  void restore(std::int64_t leaf)
  {
    for (int e = fronts_[leaf].edge; e >= 0; e = fronts_[leaf].edge)
    {
      graph_.restore(e);
      leaf = graph_.otherEnd(e, leaf);
    }
  }

  CurveGraph& graph_;
  const NetworkInput& input_;
  std::vector<Front> fronts_;
  std::vector<std::int64_t> leaves_; ///< where curves stay
  std::priority_queue<Event, std::vector<Event>, std::greater<>> queue_;
};

/// Whether an edge of a curve is outside the solid somewhere.
bool leavesSolid(const NetworkEdge& edge, const NetworkInput& input)
{
  const glm::dvec3& a = input.positions[edge.ends[0]];
  const glm::dvec3& b = input.positions[edge.ends[1]];
  const double length = glm::distance(a, b);
  // A point with this radius has no surface between itself and the other end.
  if (std::max(input.radii[edge.ends[0]], input.radii[edge.ends[1]]) > length)
  {
    return false;
  }
  constexpr int kParts = 8;
  for (int i = 0; i <= kParts; ++i)
  {
    if (!input.probe.inside(glm::mix(a, b, static_cast<double>(i) / kParts)))
    {
      return true;
    }
  }
  return false;
}

/// Points around one end of an edge, along other edges, up to some radii away from it.
std::vector<std::int64_t> around(const CurveGraph& graph, const NetworkInput& input, int without,
  std::int64_t start)
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
    widest = std::max(widest, input.radii[point]);
    if (length > kReach * std::max(widest, input.step))
    {
      break;
    }
    if (!reached.insert(point).second)
    {
      continue;
    }
    graph.find(point,
      [&, length = length, point = point](int e)
      {
        const std::int64_t next = graph.otherEnd(e, point);
        if (e != without && reached.count(next) == 0)
        {
          queue.emplace(length + glm::distance(input.positions[point], input.positions[next]),
            next);
        }
        return false;
      });
  }
  return { reached.begin(), reached.end() };
}

/// Whether an edge outside the solid leads back to where it comes from, and belongs to a loop that
/// is longer than this detour.
bool isDetour(const CurveGraph& graph, const NetworkInput& input, int e)
{
  const auto& ends = graph.edge(e).ends;
  const std::vector<std::int64_t> before = around(graph, input, e, ends[0]);
  const std::vector<std::int64_t> after = around(graph, input, e, ends[1]);
  std::vector<std::int64_t> both;
  std::set_intersection(before.begin(), before.end(), after.begin(), after.end(),
    std::back_inserter(both));
  if (!both.empty())
  {
    return false;
  }
  // A ball in the solid that holds a point of either side joins them.
  return std::any_of(before.begin(), before.end(),
    [&](std::int64_t a)
    {
      return std::any_of(after.begin(), after.end(),
        [&](std::int64_t b)
        {
          return glm::distance(input.positions[a], input.positions[b]) <
            std::max(input.radii[a], input.radii[b]);
        });
    });
}

} // namespace

void burnCurves(CurveGraph& graph, const NetworkInput& input, const Checkpoint& checkpoint)
{
  CurveFire(graph, input).burn(checkpoint);
}

void openLoops(CurveGraph& graph, const NetworkInput& input)
{
  std::vector<char> leaves(static_cast<std::size_t>(graph.size()), 0);
  tbb::parallel_for(0, graph.size(),
    [&](int e) { leaves[e] = graph.alive(e) && leavesSolid(graph.edge(e), input) ? 1 : 0; });
  std::vector<int> outside;
  for (int e = 0; e < graph.size(); ++e)
  {
    if (leaves[e] != 0)
    {
      outside.push_back(e);
    }
  }
  if (outside.empty())
  {
    return;
  }
  DisjointSets pieces(input.positions.size());
  const auto join = [&](int e)
  { return pieces.join(graph.edge(e).ends[0], graph.edge(e).ends[1]); };
  for (int e = 0; e < graph.size(); ++e)
  {
    if (graph.alive(e) && !std::binary_search(outside.begin(), outside.end(), e))
    {
      join(e);
    }
  }
  for (const int e : outside)
  {
    if (!join(e) && !isDetour(graph, input, e))
    {
      graph.remove(e);
    }
  }
}

} // namespace medial
