#pragma once

#include "medial/distance_field.h"
#include "medial/export.h"
#include "medial/grid.h"
#include "medial/run_statistics.h"
#include "medial/triangle_mesh.h"

#include <cstdint>
#include <vector>

namespace medial
{

/// The processes that compute together, and how they talk. The library knows no MPI: this is
/// derived from for it.
class MEDIAL_EXPORT Communicator
{
public:
  /// Bytes for one rank.
  using Message = std::vector<char>;

  virtual ~Communicator() = default; ///< to be derived from

  /// Number of this process, in [0, size()).
  virtual int rank() const = 0;
  /// Number of processes, at least 1.
  virtual int size() const = 0;
  /// Sends a message to every rank, this one too, and receives one from each. Every rank calls it,
  /// as often as the others.
  /// @param messages one for each rank; empty ones are allowed.
  /// @return those that the ranks have sent to this one, in the order of ranks.
  virtual std::vector<Message> exchange(std::vector<Message> messages) = 0;
};

/// The part of a surface that one rank has: any of its triangles, or none.
struct MEDIAL_EXPORT SurfacePiece
{
  /// Made by buildTriangleMesh(), or empty. `triangleCells` are numbers in the whole surface, each
  /// on one rank only; triangles count in their order.
  TriangleMesh mesh;
  /// Numbers of mesh.points in the whole surface, each >= 0; points count in their order. Points
  /// at the same position are one, whatever their numbers and ranks: the lowest number counts.
  std::vector<std::int64_t> pointOrder;
};

/// Numbers the points and cells of pieces, one piece after the other in the order of ranks. Every
/// rank calls it.
/// @param mesh with the numbers of its cells within the piece.
/// @param points, cells how many the piece has.
MEDIAL_EXPORT SurfacePiece inRankOrder(Communicator& communicator, TriangleMesh mesh,
  std::int64_t points, std::int64_t cells);

/// What a rank has held and sent.
struct RankCounts
{
  std::int64_t ownTriangles = 0;  ///< triangles of the surface over the number of ranks, about
  std::int64_t heldTriangles = 0; ///< those that can be closest in the extent, and their neighbours
  std::int64_t bytesSent = 0;     ///< to other ranks
};

/// Computes the distance field of a surface that lies in pieces on several ranks, each rank for its
/// own extent. No rank holds the whole surface. Bit for bit the field is that which one process
/// computes of the whole surface by Engine::Processor, whatever the pieces, the extents and the
/// number of ranks. Every rank calls it, with the same grid and options.
///
/// @param extent of this rank; may be empty.
/// @param options sign must be None or Pseudonormal; the engine is the processor.
/// @param counts receives what the rank has held; may be null.
/// @throws Error on every rank, with the message of the first that failed: as
///   computeDistanceField(), and InvalidInput for a surface with edges of three triangles or more,
///   with segments or points of no triangle, or with a sign that needs the whole.
MEDIAL_EXPORT RunStatistics computeDistanceField(Communicator& communicator,
  const SurfacePiece& piece, const Grid& grid, const Extent& extent, FieldSink& sink,
  const DistanceFieldOptions& options, RankCounts* counts = nullptr);

/// Cuts a grid into extents of about the same work, one for each rank: the ends of a cut lie where
/// the field is computed in one go, so that nothing is computed twice.
/// @param parts number of extents, at least 1. Where the grid is too small for them, some are
/// empty.
MEDIAL_EXPORT std::vector<Extent> partsOfGrid(const Grid& grid, int parts);

} // namespace medial
