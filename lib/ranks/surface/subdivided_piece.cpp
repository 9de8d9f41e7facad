#include "base/checkpoint.h"
#include "base/run.h"
#include "medial/ranks.h"
#include "mesh/edge_halving.h"
#include "ranks/collective.h"
#include "ranks/surface/distributed_surface.h"

#include <array>
#include <functional>
#include <unordered_map>
#include <vector>

namespace medial
{
namespace
{

/// Numbers the points of a piece as in the whole, and halves its long edges once. An edge has the
/// same number on all ranks, and edges come in the order in which one process halves them: so a new
/// point has the number of its edge, after those of all points.
/// @return whether some rank had a long edge.
bool halveOnce(Communicator& communicator, double maxEdge, const Checkpoint& checkpoint,
  PieceSubdivision& result)
{
  SurfacePiece& piece = result.piece;
  const DistributedSurface surface(communicator, piece);
  piece.pointOrder.assign(surface.pointsOfPiece().begin(), surface.pointsOfPiece().end());
  piece.weld = false; // new points of bodies that touch stay apart, as in one process
  const std::vector<std::array<int, 3>> edges =
    surface.edgesOfPiece(communicator, piece.mesh.triangles.size());
  std::unordered_map<int, int> middles; // by the edge
  const bool changed = halveLongEdges(
    maxEdge, checkpoint,
    [&](std::size_t triangle, int side) -> int& {
      return middles.insert({ edges[triangle][side], -1 }).first->second;
    },
    piece.mesh, result.parents);
  piece.pointOrder.resize(piece.mesh.points.size());
  for (const auto& [edge, middle] : middles)
  {
    if (middle >= 0)
    {
      piece.pointOrder[middle] = std::int64_t{ surface.pointCount() } + edge;
    }
  }
  return maximum(communicator, changed ? 1 : 0) != 0;
}

} // namespace

PieceSubdivision subdivide(Communicator& communicator, const SurfacePiece& piece, double maxEdge,
  const Execution& execution)
{
  PieceSubdivision result;
  agree(communicator,
    [&]
    {
      requireMaxEdge(maxEdge);
      const Checkpoint checkpoint(Run(execution), 0.0, "subdivision");
      result.piece = piece;
      do
      {
        const std::vector<double> needed{ trianglesNeeded(result.piece.mesh, maxEdge) };
        requireFew(combined(communicator, needed, std::plus<>()).front(), maxEdge);
      } while (halveOnce(communicator, maxEdge, checkpoint, result));
    });
  return result;
}

} // namespace medial
