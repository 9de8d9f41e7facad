#pragma once

#include "skeleton/sheet_fire.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace medial
{

/// A curve as ids of points of the axis in their order. A single id is a point on its own; a closed
/// curve ends with its first id.
using CurvePath = std::vector<std::int64_t>;

/// A graph of points of the axis.
class CurveGraph
{
public:
  /// @param edges must outlive this.
  /// @param vertices points of no edge.
  CurveGraph(const std::vector<NetworkEdge>& edges, const std::vector<std::int64_t>& vertices,
    std::size_t pointCount);

  int size() const { return static_cast<int>(edges_.size()); }
  const NetworkEdge& edge(int e) const { return edges_[e]; }
  bool alive(int e) const { return alive_[e] != 0; }
  int degree(std::int64_t point) const { return degrees_[point]; }
  std::int64_t otherEnd(int e, std::int64_t point) const
  {
    return edges_[e].ends[0] == point ? edges_[e].ends[1] : edges_[e].ends[0];
  }
  void remove(int e)
  {
    alive_[e] = 0;
    for (const std::int64_t end : edges_[e].ends)
    {
      --degrees_[end];
    }
  }
  void restore(int e)
  {
    alive_[e] = 1;
    for (const std::int64_t end : edges_[e].ends)
    {
      ++degrees_[end];
      used_[end] = 1;
    }
  }
  /// Takes a point without edges away.
  void drop(std::int64_t point) { used_[point] = 0; }
  /// Returns the lowest edge at a point that passes a test; -1 if there is none.
  template <typename Passes>
  int find(std::int64_t point, const Passes& passes) const
  {
    for (std::size_t i = offsets_[point]; i < offsets_[point + 1]; ++i)
    {
      if (this->alive(incident_[i]) && passes(incident_[i]))
      {
        return incident_[i];
      }
    }
    return -1;
  }
  int anyEdge(std::int64_t point) const
  {
    return this->find(point, [](int) { return true; });
  }

  /// The paths between points that do not have two edges, then the closed ones. What is removed by
  /// then can no longer be restored.
  std::vector<CurvePath> paths();

  /// Removes its edges, and its points as far as they have no others.
  void removePath(const CurvePath& path);
  /// Keeps a point that has no edges as a path of its own.
  void keep(std::int64_t point) { used_[point] = 1; }

private:
  const std::vector<NetworkEdge>& edges_;
  std::vector<char> alive_;
  std::vector<std::size_t> offsets_;
  std::vector<int> incident_;
  std::vector<int> degrees_;
  std::vector<char> used_;
  std::vector<std::int64_t> points_; ///< all that may be used, ascending
  std::vector<int> followed_;        ///< per edge: the last round in which paths() went along it
  int round_ = 0;
};

} // namespace medial
