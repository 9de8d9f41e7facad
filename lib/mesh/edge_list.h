#pragma once

#include "base/checkpoint.h"
#include "medial/triangle_mesh.h"

#include <array>
#include <cstddef>
#include <vector>

namespace medial
{

/// The distinct undirected edges of triangles and segments, in ascending order of their points.
class EdgeList
{
public:
  EdgeList(const TriangleMesh& mesh, const Checkpoint& checkpoint);

  int size() const { return size_; }
  /// The edges from each corner of a triangle to the next.
  std::array<int, 3> ofTriangle(std::size_t triangle) const
  {
    const int* sides = &edges_[3 * triangle];
    return { sides[0], sides[1], sides[2] };
  }
  int ofSegment(std::size_t segment) const { return edges_[triangleSides_ + segment]; }

private:
  struct Side
  {
    int low;
    int high;
  };

  static void addSide(int a, int b, std::vector<Side>& sides);
  /// Numbers the sides, those between the same points alike.
  void number(const std::vector<Side>& sides, std::size_t points, const Checkpoint& checkpoint);

  std::size_t triangleSides_;
  std::vector<int> edges_; ///< of the sides of all triangles, then of the segments
  int size_ = 0;           ///< number of edges
};

} // namespace medial
