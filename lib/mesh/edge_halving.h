#pragma once

#include "base/checkpoint.h"
#include "medial/subdivision.h"
#include "medial/triangle_mesh.h"

#include <array>
#include <cstddef>
#include <vector>

namespace medial
{

/// @throws Error InvalidInput for a maximum edge length outside (0, infinity).
void requireMaxEdge(double maxEdge);

/// Returns a lower bound of the number of triangles that edges of a length need.
double trianglesNeeded(const TriangleMesh& mesh, double maxEdge);
/// @throws Error InvalidInput for more triangles than subdivide() makes.
void requireFew(double triangles, double maxEdge);

bool isLong(const TriangleMesh& mesh, int a, int b, double maxEdge);
Point3 middleOf(const TriangleMesh& mesh, int a, int b);

/// Replaces triangles by those into which points in the middle of their sides cut them.
/// @param middles of each triangle, from each corner to the next; -1 for none.
/// @return whether there is such a point.
bool splitTriangles(const std::vector<std::array<int, 3>>& middles, const Checkpoint& checkpoint,
  TriangleMesh& mesh);

/// Halves all edges that are longer than a limit once.
/// @param middleAt(triangle, side) returns where the point in the middle of a triangle's side is
///   kept, the same for all triangles at an edge: -1 until there is one.
/// @return whether there was a long edge.
template <typename MiddleAt>
bool halveLongEdges(double maxEdge, const Checkpoint& checkpoint, const MiddleAt& middleAt,
  TriangleMesh& mesh, std::vector<std::array<int, 2>>& parents)
{
  std::vector<std::array<int, 3>> middles(mesh.triangles.size());
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
  {
    checkpoint(i);
    const std::array<int, 3> corners = mesh.triangles[i];
    for (int side = 0; side < 3; ++side)
    {
      int& middle = middleAt(i, side);
      const int a = corners[side];
      const int b = corners[(side + 1) % 3];
      if (middle < 0 && isLong(mesh, a, b, maxEdge))
      {
        middle = static_cast<int>(mesh.points.size());
        mesh.points.push_back(middleOf(mesh, a, b));
        parents.push_back({ a, b });
      }
      middles[i][side] = middle;
    }
  }
  return splitTriangles(middles, checkpoint, mesh);
}

} // namespace medial
