#pragma once

#include "medial/axis_coverage.h"
#include "medial/cell_topology.h"
#include "medial/compute_medial_axis.h"
#include "medial/distance_field.h"
#include "medial/execution.h"
#include "medial/export.h"
#include "medial/grid.h"
#include "medial/medial_axis.h"
#include "medial/medial_model.h"
#include "medial/reconstruction.h"
#include "medial/run_statistics.h"
#include "medial/side.h"
#include "medial/thickness.h"
#include "medial/thickness_regions.h"
#include "medial/triangle_mesh.h"

#include <array>
#include <cstdint>
#include <functional>
#include <stdexcept>
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

/// A failure that the library does not expect, by another exception than Error and
/// std::bad_alloc, on one of several ranks: every rank throws it.
class MEDIAL_EXPORT RankFault : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

/// Does work as agree().
MEDIAL_EXPORT void agreeOn(Communicator& communicator, const std::function<void()>& work);

/// Does work that may fail on some ranks only, wherever it is: the others learn of it when they
/// exchange something the next time, by gathered() or by what this header has, at the latest at the
/// end. Work may call agree() again. Every rank calls it.
/// @param work of this rank, called once, without arguments.
/// @throws Error on every rank if any has failed: that of the first of them, whose name it has
///   unless all have failed alike. std::bad_alloc becomes OutOfMemory.
/// @throws RankFault likewise, for any other exception.
template <typename Work>
void agree(Communicator& communicator, const Work& work)
{
  agreeOn(communicator, std::cref(work)); // a copy would take memory outside
}

/// Returns what the ranks pass on to all, in their order. Every rank calls it, within agree().
/// @throws Error as agree().
MEDIAL_EXPORT std::vector<Communicator::Message> gathered(Communicator& communicator,
  const Communicator::Message& own);

/// The part of a surface that one rank has: any of its triangles, or none.
struct MEDIAL_EXPORT SurfacePiece
{
  /// Made by buildTriangleMesh(), or empty. `triangleCells` are numbers in the whole surface, each
  /// on one rank only; triangles count in their order.
  TriangleMesh mesh;
  /// Numbers of mesh.points in the whole surface, each >= 0; points count in their order. Points
  /// at the same position are one, whatever their numbers and ranks: the lowest number counts.
  std::vector<std::int64_t> pointOrder;
  /// Whether points at the same position are one. If not, only those with the same number are, as
  /// in a mesh that subdivide() has made. The same on every rank.
  bool weld = true;
};

/// Numbers the points and cells of pieces, one piece after the other in the order of ranks. Every
/// rank calls it.
/// @param mesh with the numbers of its cells within the piece.
/// @param points, cells how many the piece has.
MEDIAL_EXPORT SurfacePiece inRankOrder(Communicator& communicator, TriangleMesh mesh,
  std::int64_t points, std::int64_t cells);

/// Drops triangles that are copies: that an earlier rank has, too, or an earlier triangle here,
/// with corners at the same places in the same orientation. Every rank calls it.
/// @param mesh of this rank, made by buildTriangleMesh(), or empty. It keeps its points.
/// @throws Error as agree().
MEDIAL_EXPORT void dropCopies(Communicator& communicator, TriangleMesh& mesh);

/// A piece of a surface with shorter edges.
struct PieceSubdivision
{
  /// The points of the original come first, new ones after them; the cells of triangles are those
  /// of the original. Points have the numbers of the mesh that one process makes of the whole.
  SurfacePiece piece;
  /// Per new point, the two points, with lower ids, that it is in the middle of, or somewhere
  /// between if it is a corner of a triangle without area in another piece.
  std::vector<std::array<int, 2>> parents;
};

/// Halves the edges of a surface in pieces that are longer than a limit, until there are none: the
/// triangles of each piece become those that subdivide() makes of them in the whole. Every rank
/// calls it, with the same limit.
/// @param maxEdge world units, in (0, infinity).
/// @throws Error on every rank, as subdivide(), and InvalidInput for a surface with segments or
///   points of no triangle, or with segments at edges that are halved.
MEDIAL_EXPORT PieceSubdivision subdivide(Communicator& communicator, const SurfacePiece& piece,
  double maxEdge, const Execution& execution = {});

/// What pieces of a surface are together: figures of TriangleMesh and MeshConnectivity.
struct SurfaceFigures
{
  std::int64_t triangles = 0; ///< of all pieces
  std::int64_t points = 0;    ///< those at the same position count once
  /// Without area, however they are kept; those in several pieces count in each.
  std::int64_t degenerateTriangles = 0;
  int components = 0;    ///< connected through points
  bool closed = false;   ///< two triangles at every edge
  bool manifold = false; ///< as MeshConnectivity::manifold()
};

/// Measures a surface that lies in pieces on several ranks. No rank holds the whole surface. Every
/// rank calls it.
/// @return the same on every rank.
/// @throws Error on every rank, with the message of the first that failed: InvalidInput for a
///   surface without triangles, and with segments or points of no triangle.
MEDIAL_EXPORT SurfaceFigures measureSurface(Communicator& communicator, const SurfacePiece& piece);

/// What a rank has held and sent.
struct RankCounts
{
  std::int64_t ownTriangles = 0;  ///< triangles of the surface over the number of ranks, about
  std::int64_t heldTriangles = 0; ///< those that can be closest in the extent, and their neighbours
  std::int64_t bytesSent = 0;     ///< to other ranks
  std::int64_t exchanges = 0;     ///< calls of Communicator::exchange()
  std::int64_t crossings = 0;     ///< of the axis, in the rank's part of it and around
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

/// Computes the medial axis of a surface that lies in pieces on several ranks. No rank holds the
/// whole surface or axis, nor the whole field, but see below. Together the pieces have the points
/// and cells that computeMedialAxis() gives in one process, to the last bit, each cell in one
/// piece, whatever the extents and the number of ranks. Every rank calls it, with the same grid,
/// extents and options.
///
/// The extents say where ranks compute the field. Once it is known where the axis is, the grid is
/// cut again, so that each rank has about as much of the axis to make.
///
/// With Topology::Preserve the first rank thins the voxels of the whole grid: it has the distances
/// there, of the surface nothing, and takes 10 bytes for each grid point. The others tell it about
/// selected crossings and closest sites, and place the points. With maxSpheres the axis is brought
/// together on the first rank, which makes it compact and has all of the result.
///
/// @param extents of all ranks; they cover the grid, each point once. Some may be empty.
/// @param sink receives the field of touchingExtent() of this rank's.
/// @param options the engine is the processor.
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

/// Makes a whole axis the only piece that has cells.
MEDIAL_EXPORT AxisPiece onlyPiece(MedialAxis axis);

/// Returns the topology of all pieces of an axis together, on every rank: as topologyOf() that of
/// the whole. Every rank calls it. The first rank brings together what is left of closed sheets,
/// and which pieces hang together.
MEDIAL_EXPORT CellTopology topologyOf(Communicator& communicator, const AxisPiece& piece);

/// Measures how much of a surface in pieces an axis in pieces leaves out, with the
/// figures of measureCoverage() in one process. Every rank calls it, with the same options, and has
/// all samples: 24 bytes each.
/// @param surface of this rank.
/// @param axis of this rank.
/// @throws Error on every rank, as measureCoverage().
MEDIAL_EXPORT AxisCoverage measureCoverage(Communicator& communicator, const SurfacePiece& surface,
  const AxisPiece& axis, double reach, const CoverageOptions& options = {});

/// Returns the bounds of all balls of a model that lies in pieces on several ranks. Every rank
/// calls it.
/// @param piece of this rank; may have nothing.
/// @return the same on every rank, world units.
/// @throws Error on every rank, as checkMedialModel().
MEDIAL_EXPORT Bounds modelBounds(Communicator& communicator, const MedialModel& piece);

/// Computes the field of a reconstruction, as computeReconstruction() does in one process, of a
/// model that lies in pieces on several ranks, each rank for its own extent. No rank holds the
/// whole model: it gets the balls, cones and wedges that can matter in its extent. Every rank calls
/// it, with the same grid and options.
///
/// The solid is the union of all pieces, so balls and cells may be in several. A ball without a
/// cell in one piece that has one in another may change the last bit of a value.
/// @param piece of this rank: any cells, and the balls that they use; may have nothing.
/// @param extent of this rank; may be empty. Extents may overlap.
/// @return one value per point of the extent, x fastest, world units. Those within three voxels of
///   the surface are bit for bit those of one process, the others have their sign and are farther
///   away.
/// @throws Error on every rank, with the message of the first that failed: as
///   computeReconstruction(), and InvalidInput for an extent that is not in the grid.
MEDIAL_EXPORT std::vector<float> computeReconstruction(Communicator& communicator,
  const MedialModel& piece, const Grid& grid, const Extent& extent,
  const ReconstructionOptions& options = {});

/// Computes the thickness of a surface that lies in pieces on several ranks. No rank holds the
/// whole surface: each computes it at places near its own part, and asks the others about theirs.
/// The values are those of computeThickness() in one process, to the last bit, whatever the pieces
/// and the number of ranks. Every rank calls it, with the same options.
///
/// With ThicknessMethod::Wall the first rank brings together the triangles with places that take
/// the value of others.
///
/// @param counts receives what the rank has held; may be null.
/// @return values of the points and triangles of the piece; min, median, max, points and without
///   are those of the whole surface.
/// @throws Error on every rank, with the message of the first that failed: as computeThickness() in
///   one process, and InvalidInput for a surface with segments or points of no triangle.
MEDIAL_EXPORT Thickness computeThickness(Communicator& communicator, const SurfacePiece& piece,
  const ThicknessOptions& options = {}, RankCounts* counts = nullptr);

/// Checks that a mesh that lies in pieces on several ranks has an inside, as requireInside() does
/// in one process. Every rank calls it.
/// @throws Error on every rank, as requireInside(), and InvalidInput for a surface with segments or
///   points of no triangle.
MEDIAL_EXPORT void requireInside(Communicator& communicator, const SurfacePiece& piece,
  const Execution& execution = {});

/// Finds where a solid that lies in pieces on several ranks is too thin or too thick, as
/// findThicknessRegions() does in one process. The first rank brings together the triangles beyond
/// limits, and no others. Every rank calls it, with the same limits.
/// @param thickness of the piece, with values of its cells.
/// @return the regions of the whole, on every rank, in the same order. The triangles and cells are
///   those of the piece.
/// @throws Error on every rank, as findThicknessRegions().
MEDIAL_EXPORT std::vector<ThicknessRegion> findThicknessRegions(Communicator& communicator,
  const SurfacePiece& piece, const Thickness& thickness, const ThicknessLimits& limits);

/// Returns an extent with the layers of points behind it, as far as the grid has them: extents that
/// lie side by side then share a layer, as VTK's images of pieces do.
MEDIAL_EXPORT Extent touchingExtent(const Grid& grid, const Extent& extent);

/// Cuts a grid into extents of about the same work, one for each rank: the ends of a cut lie where
/// the field is computed in one go, so that nothing is computed twice.
/// @param parts number of extents, at least 1. Where the grid is too small for them, some are
/// empty.
MEDIAL_EXPORT std::vector<Extent> partsOfGrid(const Grid& grid, int parts);

/// Cuts a grid into extents whose field takes about the same work, one for each rank. Each rank
/// computes the field in a sample of tiles: an eighth of them, fewer where the grid is large. No
/// result depends on how a grid is cut. Every rank calls it.
/// @param side that is looked at: computeMedialAxis() leaves out the field of the other side where
///   no array is wanted and winding numbers give the sign.
/// @return the same on every rank. Where the grid is too small, some are empty.
/// @throws Error as computeDistanceField(), on every rank.
MEDIAL_EXPORT std::vector<Extent> partsByWork(Communicator& communicator, const SurfacePiece& piece,
  const Grid& grid, const DistanceFieldOptions& options, Side side = Side::Both);

} // namespace medial
