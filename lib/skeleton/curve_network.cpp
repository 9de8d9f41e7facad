#include "skeleton/curve_network.h"

#include "skeleton/open_loops.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>
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
  {
  }

  std::vector<CurvePath> prune(const Checkpoint& checkpoint)
  {
    do
    {
      checkpoint();
      while (this->trim())
      {
      }
    } while (this->removeShort());
    return graph_.paths();
  }

private:
  bool free(std::int64_t point) const { return graph_.degree(point) == 1; }
  double width(std::int64_t point) const { return input_.widths[point]; }
  /// What branches at a junction are compared with.
  double size(std::int64_t junction) const
  {
    const double radius = input_.radii[junction];
    return this->width(junction) > kTubeWidth * radius ? this->width(junction) : radius;
  }

  /// Returns how many points to take from the front of a path, which is a free end: up to where
  /// the width grows inwards by less than kSlope of the length for some length. All, if there is no
  /// such place.
  std::size_t surplus(const CurvePath& path) const
  {
    const std::vector<double> lengths = arcLengths(path, input_.positions);
    const auto potential = [&](std::size_t i)
    { return this->width(path[i]) - kSlope * lengths[i]; };
    std::size_t best = 0;
    for (std::size_t i = 1; i < path.size(); ++i)
    {
      const double radius = input_.radii[path[best]];
      const double run = std::max(kMinRun * input_.step,
        kMinRunOfRadius * radius + kMinRunOfSheet * (this->width(path[best]) - radius));
      if (potential(i) > potential(best))
      {
        best = i;
      }
      else if (lengths[i] - lengths[best] >= run)
      {
        return best;
      }
    }
    return path.size();
  }

  void cut(CurvePath path, std::size_t count)
  {
    path.resize(std::min(path.size(), count + 1));
    graph_.removePath(path);
  }

  /// Removes what is surplus at free ends. Returns whether there was any.
  bool trim()
  {
    bool changed = false;
    for (CurvePath path : graph_.paths())
    {
      const bool isolated = this->free(path.front()) && this->free(path.back());
      if (path.size() < 2 || path.front() == path.back() ||
        (!this->free(path.front()) && !this->free(path.back())))
      {
        continue;
      }
      if (!this->free(path.front()))
      {
        std::reverse(path.begin(), path.end());
      }
      const std::size_t front = this->surplus(path);
      std::size_t back = 0;
      if (isolated)
      {
        std::reverse(path.begin(), path.end());
        back = this->surplus(path);
        std::reverse(path.begin(), path.end());
        if (front + back + 1 >= path.size())
        {
          this->shrink(path);
          continue;
        }
      }
      if (front > 0)
      {
        const std::int64_t end = path.back();
        this->cut(path, front);
        if (graph_.degree(end) == 0)
        {
          graph_.keep(end);
        }
        changed = true;
      }
      if (back > 0)
      {
        std::reverse(path.begin(), path.end());
        this->cut(path, back);
        changed = true;
      }
    }
    return changed;
  }

  /// Replaces a path of two free ends by its widest point.
  void shrink(const CurvePath& path)
  {
    const std::int64_t widest = *std::max_element(path.begin(), path.end(),
      [this](std::int64_t a, std::int64_t b) { return this->width(a) < this->width(b); });
    graph_.removePath(path);
    graph_.keep(widest);
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
