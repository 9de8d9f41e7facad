#include "medial/subdivision.h"

#include "base/checkpoint.h"
#include "medial/error.h"
#include "mesh/corner_insertion.h"
#include "mesh/edge_halving.h"
#include "mesh/edge_list.h"

#include <cstdint>
#include <new>
#include <vector>

namespace medial
{
namespace
{

/// Inserts corners of triangles without area into the edges they lie on. If such triangles were
/// halved, their parts would be in each other's way: points of different edges at the same place.
void insertCorners(double maxEdge, const Checkpoint& checkpoint, TriangleMesh& mesh)
{
  const auto numberOf = [](int point) { return std::int64_t{ point }; };
  const auto pointOf = [](const CornerOnEdge& corner, int, int)
  { return static_cast<int>(corner.corner); };
  for (int round = 0; round < kMaxInsertions; ++round)
  {
    const std::vector<CornerOnEdge> corners = cornersOnEdges(mesh, numberOf, checkpoint);
    if (corners.empty() || !hasUsableTriangle(mesh))
    {
      return;
    }
    CornerInsertion(corners).divide(maxEdge, numberOf, pointOf, checkpoint, mesh);
  }
}

} // namespace

Subdivision subdivide(const TriangleMesh& mesh, double maxEdge, const Execution& execution)
{
  requireMaxEdge(maxEdge);
  const Run run(execution);
  const Checkpoint checkpoint(run, 0.0, "subdivision");
  try
  {
    Subdivision result;
    result.mesh = mesh;
    insertCorners(maxEdge, checkpoint, result.mesh);
    bool changed = true;
    while (changed)
    {
      requireFew(trianglesNeeded(result.mesh, maxEdge), maxEdge);
      const EdgeList edges(result.mesh, checkpoint);
      std::vector<int> middles(edges.size(), -1);
      changed = halveLongEdges(
        maxEdge, checkpoint,
        [&](std::size_t triangle, int side) -> int&
        { return middles[edges.ofTriangle(triangle)[side]]; },
        result.mesh, result.parents);
    }
    return result;
  }
  catch (const std::bad_alloc&)
  {
    throw Error(ErrorCode::OutOfMemory, "out of memory for a mesh with shorter edges");
  }
}

} // namespace medial
