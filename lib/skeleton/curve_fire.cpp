#include "skeleton/curve_fire.h"

#include <algorithm>
#include <functional>
#include <queue>
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

} // namespace

void burnCurves(CurveGraph& graph, const NetworkInput& input, const Checkpoint& checkpoint)
{
  CurveFire(graph, input).burn(checkpoint);
}

} // namespace medial
