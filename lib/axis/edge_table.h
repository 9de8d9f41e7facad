#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace medial
{

/// The edges of polygons, looked up by their ends.
class EdgeTable
{
public:
  using Edge = std::array<std::int64_t, 2>; ///< point ids, in either order

  /// @param edges one for each polygon at an edge; all ids in [0, pointCount).
  EdgeTable(const std::vector<Edge>& edges, std::size_t pointCount);

  /// Returns how many polygons have an edge.
  std::size_t count(const Edge& edge) const;

  /// Calls visit(edge, count) once for each edge, in ascending order; its lower id comes first.
  template <typename Visit>
  void forEach(const Visit& visit) const
  {
    for (std::size_t low = 0; low + 1 < offsets_.size(); ++low)
    {
      for (std::size_t i = offsets_[low], next = i; i < offsets_[low + 1]; i = next)
      {
        while (next < offsets_[low + 1] && high_[next] == high_[i])
        {
          ++next;
        }
        visit(Edge{ static_cast<std::int64_t>(low), high_[i] }, next - i);
      }
    }
  }

private:
  std::vector<std::size_t> offsets_; ///< into high_, by the lower id
  std::vector<std::int64_t> high_;   ///< the higher ids, ascending
};

/// Appends the edges of a polygon.
/// @param corners point ids in cyclic order.
template <typename Polygon>
void addEdges(const Polygon& corners, std::vector<EdgeTable::Edge>& edges)
{
  for (std::size_t i = 0; i < corners.size(); ++i)
  {
    edges.push_back({ corners[i], corners[(i + 1) % corners.size()] });
  }
}

} // namespace medial
