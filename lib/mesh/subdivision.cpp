#include "medial/subdivision.h"

#include "base/checkpoint.h"
#include "medial/error.h"
#include "mesh/edge_halving.h"
#include "mesh/edge_list.h"

#include <new>

namespace medial
{

Subdivision subdivide(const TriangleMesh& mesh, double maxEdge, const Execution& execution)
{
  requireMaxEdge(maxEdge);
  const Run run(execution);
  const Checkpoint checkpoint(run, 0.0, "subdivision");
  try
  {
    Subdivision result;
    result.mesh = mesh;
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
