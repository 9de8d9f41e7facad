#include "base/checkpoint.h"
#include "base/run.h"
#include "medial/ranks.h"
#include "mesh/corner_insertion.h"
#include "mesh/edge_halving.h"
#include "ranks/collective.h"
#include "ranks/surface/distributed_surface.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <unordered_map>
#include <vector>

namespace medial
{
namespace
{

/// Numbers the points of a piece as in the whole. The same points are one from then on, but no
/// others: new points of bodies that touch stay apart, as in one process.
void numberPiece(const DistributedSurface& surface, SurfacePiece& piece)
{
  piece.pointOrder.assign(surface.pointsOfPiece().begin(), surface.pointsOfPiece().end());
  piece.weld = false;
}

/// Facets with equal corners have become segments and points of triangles' edges. They go, since
/// the edges that are halved would no longer hold them.
/// @throws Error InvalidInput for those of no triangle.
void dropCollapsed(Communicator& communicator, SurfacePiece& piece)
{
  if (maximum(communicator, piece.mesh.segments.size() + piece.mesh.vertices.size()) > 0)
  {
    const DistributedSurface checked(communicator, piece);
    piece.mesh.segments.clear();
    piece.mesh.vertices.clear();
  }
}

/// Inserts corners of triangles without area into the edges they lie on, as in one process. A piece
/// gets those of others.
/// @return whether there were any.
bool insertOnce(Communicator& communicator, double maxEdge, const Checkpoint& checkpoint,
  PieceSubdivision& result)
{
  SurfacePiece& piece = result.piece;
  const bool usable = maximum(communicator, hasUsableTriangle(piece.mesh) ? 1 : 0) != 0;
  const auto found = cornersOnEdges(
    piece.mesh, [](int point) { return std::int64_t{ point }; }, checkpoint)
                       .size();
  if (!usable || maximum(communicator, found) == 0)
  {
    return false;
  }
  numberPiece(DistributedSurface(communicator, piece), piece);
  const auto numberOf = [&piece](int point) { return piece.pointOrder[point]; };
  const CornerInsertion insertion(
    flattened(gathered(communicator, cornersOnEdges(piece.mesh, numberOf, checkpoint))));
  std::unordered_map<std::int64_t, int> points;
  for (std::size_t point = 0; point < piece.pointOrder.size(); ++point)
  {
    points.insert({ piece.pointOrder[point], static_cast<int>(point) });
  }
  const auto pointOf = [&](const CornerOnEdge& corner, int a, int b)
  {
    const auto next = static_cast<int>(piece.mesh.points.size());
    const auto [point, isNew] = points.insert({ corner.corner, next });
    if (isNew)
    {
      piece.mesh.points.push_back(corner.position);
      piece.pointOrder.push_back(corner.corner);
      result.parents.push_back({ a, b });
    }
    return point->second;
  };
  insertion.divide(maxEdge, numberOf, pointOf, checkpoint, piece.mesh);
  return true;
}

/// Numbers the points of a piece as in the whole, and halves its long edges once. An edge has the
/// same number on all ranks, and edges come in the order in which one process halves them: so a new
/// point has the number of its edge, after those of all points.
/// @return whether some rank had a long edge.
bool halveOnce(Communicator& communicator, double maxEdge, const Checkpoint& checkpoint,
  PieceSubdivision& result)
{
  SurfacePiece& piece = result.piece;
  const DistributedSurface surface(communicator, piece);
  numberPiece(surface, piece);
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
      dropCollapsed(communicator, result.piece);
      for (int round = 0; round < kMaxInsertions; ++round)
      {
        if (!insertOnce(communicator, maxEdge, checkpoint, result))
        {
          break;
        }
      }
      do
      {
        const std::vector<double> needed{ trianglesNeeded(result.piece.mesh, maxEdge) };
        requireFew(combined(communicator, needed, std::plus<>()).front(), maxEdge);
      } while (halveOnce(communicator, maxEdge, checkpoint, result));
    });
  return result;
}

} // namespace medial
