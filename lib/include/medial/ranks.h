#pragma once

#include "medial/compute_medial_axis.h"
#include "medial/distance_field.h"
#include "medial/export.h"
#include "medial/grid.h"
#include "medial/medial_axis.h"
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
  /// as often as the others. Where it throws, this rank has sent and received either all that the
  /// others wait for or nothing.
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
  std::int64_t exchanges = 0;     ///< calls of Communicator::exchange()
};

/// Computes the distance field of a surface that lies in pieces on several ranks, each rank for its
/// own extent. No rank holds the whole surface. Bit for bit the field is that which one process
/// computes of the whole surface by Engine::Processor, whatever the pieces, the extents and the
/// number of ranks. Every rank calls it, with the same grid and options.
///
/// With signs by winding numbers every rank has the lids of all holes: about as many triangles as
/// the holes have edges.
///
/// @param extent of this rank; may be empty.
/// @param options the engine is the processor.
/// @param counts receives what the rank has held; may be null.
/// @throws Error on every rank, with the message of the first that failed: as
///   computeDistanceField(), and InvalidInput for a surface with segments or points of no triangle.
MEDIAL_EXPORT RunStatistics computeDistanceField(Communicator& communicator,
  const SurfacePiece& piece, const Grid& grid, const Extent& extent, FieldSink& sink,
  const DistanceFieldOptions& options, RankCounts* counts = nullptr);

/// What one rank has of an axis.
struct AxisPiece
{
  /// The cells of this rank, and all points that they use: those on a cut are in several pieces.
  /// The statistics are those of this rank.
  MedialAxis axis;
  std::vector<std::int64_t> globalPointIds; ///< numbers of the points in the axis of one process
  /// Numbers of the cells in the axis of one process: of the vertices, then of the lines, the quads
  /// and the triangles.
  std::vector<std::int64_t> globalCellIds;
  std::int64_t points = 0; ///< number of points of the whole axis
  std::int64_t cells = 0;  ///< number of cells of the whole axis
};

/// Computes the medial axis of a surface that lies in pieces on several ranks, each rank for its
/// own extent. No rank holds the whole surface, field or axis. Together the pieces have the points
/// and cells that computeMedialAxis() gives in one process, to the last bit, each cell in one
/// piece, whatever the extents and the number of ranks. Every rank calls it, with the same grid,
/// extents and options.
///
/// @param extents of all ranks; they cover the grid, each point once. Some may be empty.
/// @param sink receives the field of touchingExtent() of this rank's.
/// @param options the topology must be Selected, maxSpheres 0; the engine is the processor.
/// @param counts receives what the rank has held; may be null.
/// @throws Error on every rank, with the message of the first that failed: as computeMedialAxis()
///   in one process and as computeDistanceField() on several, and InvalidInput for extents that
///   overlap or leave a gap.
MEDIAL_EXPORT AxisPiece computeMedialAxis(Communicator& communicator, const SurfacePiece& piece,
  const Grid& grid, const std::vector<Extent>& extents, FieldSink& sink,
  const MedialAxisOptions& options, RankCounts* counts = nullptr);

/// Brings the pieces of an axis together on the first rank. Every rank calls it.
/// @return there the axis of one process, with the statistics of that rank; elsewhere nothing of
///   it.
MEDIAL_EXPORT MedialAxis gatherMedialAxis(Communicator& communicator, const AxisPiece& piece);

/// Returns an extent with the layers of points behind it, as far as the grid has them: extents that
/// lie side by side then share a layer, as VTK's images of pieces do.
MEDIAL_EXPORT Extent touchingExtent(const Grid& grid, const Extent& extent);

/// Cuts a grid into extents of about the same work, one for each rank: the ends of a cut lie where
/// the field is computed in one go, so that nothing is computed twice.
/// @param parts number of extents, at least 1. Where the grid is too small for them, some are
/// empty.
MEDIAL_EXPORT std::vector<Extent> partsOfGrid(const Grid& grid, int parts);

/// Cuts a grid into extents that take about the same work, one for each rank. Each rank computes
/// the field in a sample of tiles: an eighth of them, fewer where the grid is large. No result
/// depends on how a grid is cut. Every rank calls it.
/// @return the same on every rank. Where the grid is too small, some are empty.
/// @throws Error as computeDistanceField(), on every rank.
MEDIAL_EXPORT std::vector<Extent> partsByWork(Communicator& communicator, const SurfacePiece& piece,
  const Grid& grid, const DistanceFieldOptions& options);

} // namespace medial
