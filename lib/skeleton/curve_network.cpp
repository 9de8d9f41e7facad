#include "skeleton/curve_network.h"

#include "skeleton/open_loops.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <unordered_map>
#include <unordered_set>
#include <utility>

namespace medial
{
namespace
{

/// The width of a branch falls towards its end by at most this part of its length.
constexpr double kSlope = 0.5;
/// The length over which that must hold: in steps, as a part of the radius, and as a part of what
/// the width exceeds it by, since the grid shows in the way that a fire takes over a sheet.
constexpr double kMinRun = 6.0;
constexpr double kMinRunOfRadius = 0.5;
constexpr double kMinRunOfSheet = 0.75;
/// By how much the grid makes the width differ where the solid is thinner than a step, in steps.
/// What falls by kSlope is lower by that after kTolerance / kSlope steps.
constexpr double kTolerance = 0.5;
/// Points on either side over which a path is averaged before it is measured.
constexpr int kSmoothed = 4;

/// Returns arc lengths along a path whose steps of the grid are averaged out.
std::vector<double> arcLengths(const CurvePath& path, const std::vector<glm::dvec3>& positions)
{
  const int count = static_cast<int>(path.size());
  const auto averaged = [&](int i)
  {
    const int reach = std::min({ kSmoothed, i, count - 1 - i });
    glm::dvec3 sum(0.0);
    for (int k = i - reach; k <= i + reach; ++k)
    {
      sum += positions[path[k]];
    }
    return sum / static_cast<double>(2 * reach + 1);
  };
  std::vector<double> lengths{ 0.0 };
  glm::dvec3 last = averaged(0);
  for (int i = 1; i < count; ++i)
  {
    const glm::dvec3 next = averaged(i);
    lengths.push_back(lengths.back() + glm::distance(last, next));
    last = next;
  }
  return lengths;
}

class Pruning
{
public:
  Pruning(CurveGraph& graph, const NetworkInput& input)
    : graph_(graph)
    , input_(input)
    , arrivals_(input.widths)
  {
  }

  std::vector<CurvePath> prune(const Checkpoint& checkpoint)
  {
    do
    {
      while (this->trim())
      {
        checkpoint();
      }
    } while (this->removeShort());
    return graph_.paths();
  }

private:
  /// What to take from the front of a path, which is a free end.
  struct Surplus
  {
    std::size_t count = 0; ///< of points
    /// Whether all of the path goes, although the width does not grow up to its other end: it is
    /// too short to tell.
    bool doubtful = false;
    double length = 0.0; ///< of the path
  };
  /// The surplus of a path that begins where another one did is the same if their last points and
  /// their numbers of points are.
  struct KnownSurplus
  {
    std::int64_t last;
    std::size_t points;
    Surplus surplus;
  };

  bool free(std::int64_t point) const { return graph_.degree(point) == 1; }
  double width(std::int64_t point) const { return input_.widths[point]; }
  /// What branches at a junction are compared with.
  double size(std::int64_t junction) const
  {
    const double radius = input_.radii[junction];
    return this->width(junction) > kTubeWidth * radius ? this->width(junction) : radius;
  }

  /// Returns what to take from the front of a path: up to where the width grows inwards by less
  /// than kSlope of the length for some length. All, if there is no such place.
  Surplus measureSurplus(const CurvePath& path) const
  {
    const std::vector<double> lengths = arcLengths(path, input_.positions);
    const auto potential = [&](std::size_t i)
    { return this->width(path[i]) - kSlope * lengths[i]; };
    // Where a sheet is thinner than a step, the grid shows in the width.
    const auto tolerance = [&](std::size_t best)
    {
      const double radius = input_.radii[path[best]];
      const bool inSheet = this->width(path[best]) > kTubeWidth * radius;
      return inSheet && radius < input_.step ? kTolerance * input_.step : 0.0;
    };
    std::size_t best = 0;
    std::size_t close = 0; // the last point as good as the best, but for the steps of the grid
    for (std::size_t i = 1; i < path.size(); ++i)
    {
      const double radius = input_.radii[path[best]];
      const double run = std::max(kMinRun * input_.step,
        kMinRunOfRadius * radius + kMinRunOfSheet * (this->width(path[best]) - radius));
      best = potential(i) > potential(best) ? i : best;
      close = potential(i) > potential(best) - tolerance(best) ? i : close;
      if (lengths[i] - lengths[best] >= run &&
        lengths[i] - lengths[close] >= run - kTolerance / kSlope * input_.step)
      {
        return { best, false, lengths.back() };
      }
    }
    const std::size_t last = path.size() - 1;
    const bool grows =
      potential(last) > potential(0) && lengths[last] - lengths[best] < kMinRun * input_.step;
    return { path.size(), !grows, lengths[last] };
  }

  /// Returns what measureSurplus() does; that of a path that stays is measured once.
  const Surplus& surplus(const CurvePath& path)
  {
    const KnownSurplus unknown{ -1, 0, {} };
    KnownSurplus& known = known_.try_emplace(path.front(), unknown).first->second;
    if (known.last != path.back() || known.points != path.size())
    {
      known = { path.back(), path.size(), this->measureSurplus(path) };
    }
    return known.surplus;
  }

  void cut(CurvePath path, std::size_t count)
  {
    path.resize(std::min(path.size(), count + 1));
    const std::int64_t end = path.back();
    arrivals_[end] =
      std::max(arrivals_[end], arrivals_[path.front()] + arcLengths(path, input_.positions).back());
    graph_.removePath(path);
    if (graph_.degree(end) == 0)
    {
      graph_.keep(end);
    }
  }

  /// Returns the paths that have a free end. It is their first point.
  std::vector<CurvePath> freePaths()
  {
    std::vector<CurvePath> result;
    for (CurvePath& path : graph_.paths())
    {
      if (path.size() < 2 || path.front() == path.back() ||
        (!this->free(path.front()) && !this->free(path.back())))
      {
        continue;
      }
      if (!this->free(path.front()))
      {
        std::reverse(path.begin(), path.end());
      }
      result.push_back(std::move(path));
    }
    return result;
  }

  /// Removes what is surplus at free ends or, if there is none without doubt, some of what may
  /// be. Returns whether there was any.
  bool trim()
  {
    bool changed = false;
    std::vector<CurvePath> doubtful;
    for (CurvePath& path : this->freePaths())
    {
      if (this->free(path.back()))
      {
        changed = this->trimIsolated(path) || changed;
        continue;
      }
      const Surplus& surplus = this->surplus(path);
      if (surplus.doubtful)
      {
        doubtful.push_back(std::move(path));
      }
      else if (surplus.count > 0)
      {
        this->cut(path, surplus.count);
        changed = true;
      }
    }
    return changed || this->removeDoubtful(doubtful);
  }

  bool trimIsolated(CurvePath& path)
  {
    const std::size_t front = this->surplus(path).count;
    std::reverse(path.begin(), path.end());
    const std::size_t back = this->surplus(path).count;
    if (front + back + 1 >= path.size())
    {
      this->shrink(path);
      return true;
    }
    if (back > 0)
    {
      this->cut(path, back);
    }
    if (front > 0)
    {
      std::reverse(path.begin(), path.end());
      this->cut(path, front);
    }
    return front > 0 || back > 0;
  }

  /// Removes one at each junction of the paths that are too short to tell what is surplus: those
  /// that a fire has burned soonest after the sheets beside them, since the others are longer
  /// without them. Returns whether there was any.
  bool removeDoubtful(const std::vector<CurvePath>& paths)
  {
    constexpr double kAbout = 2.0;
    std::vector<std::pair<double, std::size_t>> byDelay;
    for (std::size_t i = 0; i < paths.size(); ++i)
    {
      const CurvePath& path = paths[i];
      const double arrival = arrivals_[path.front()] + this->surplus(path).length;
      byDelay.emplace_back(arrival - this->width(path.back()), i);
    }
    std::sort(byDelay.begin(), byDelay.end());
    std::unordered_set<std::int64_t> junctions;
    for (const auto& [delay, i] : byDelay)
    {
      if (delay > std::max(input_.step, kAbout * byDelay.front().first))
      {
        break;
      }
      if (junctions.insert(paths[i].back()).second)
      {
        this->cut(paths[i], paths[i].size());
      }
    }
    return !paths.empty();
  }

  /// Replaces a path of two free ends by the middle of its widest part.
  void shrink(const CurvePath& path)
  {
    double most = 0.0;
    for (const std::int64_t point : path)
    {
      most = std::max(most, this->width(point));
    }
    std::vector<std::int64_t> widest;
    std::copy_if(path.begin(), path.end(), std::back_inserter(widest),
      [&](std::int64_t point) { return this->width(point) >= most - input_.step; });
    graph_.removePath(path);
    graph_.keep(widest[widest.size() / 2]);
  }

  /// Removes the shortest branch of those at each junction that are too short. Returns whether
  /// there was any.
  bool removeShort()
  {
    const std::vector<CurvePath> paths = graph_.paths();
    std::unordered_map<std::int64_t, std::pair<double, std::size_t>> shortest;
    for (std::size_t i = 0; i < paths.size(); ++i)
    {
      const CurvePath& path = paths[i];
      if (path.size() < 2 || this->free(path.front()) == this->free(path.back()))
      {
        continue;
      }
      const std::int64_t junction = this->free(path.front()) ? path.back() : path.front();
      const double ratio = arcLengths(path, input_.positions).back() / this->size(junction);
      if (ratio < input_.minBranch)
      {
        const auto [entry, added] = shortest.try_emplace(junction, ratio, i);
        if (!added && ratio < entry->second.first)
        {
          entry->second = { ratio, i };
        }
      }
    }
    for (const auto& [junction, entry] : shortest)
    {
      graph_.removePath(paths[entry.second]);
    }
    return !shortest.empty();
  }

  CurveGraph& graph_;
  const NetworkInput& input_;
  std::unordered_map<std::int64_t, KnownSurplus> known_; ///< of paths, by their first points
  std::vector<double> arrivals_; ///< per point: when a fire along what has been cut comes there
};

} // namespace

std::vector<CurvePath> curveNetwork(const std::vector<NetworkEdge>& edges,
  const std::vector<std::int64_t>& vertices, const NetworkInput& input,
  const Checkpoint& checkpoint)
{
  CurveGraph graph(edges, vertices, input.positions.size());
  burnCurves(graph, input, checkpoint);
  openLoops(graph, input);
  return Pruning(graph, input).prune(checkpoint);
}

} // namespace medial
