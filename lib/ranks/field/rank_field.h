#pragma once

#include "base/run.h"
#include "culling/group_list.h"
#include "field/crossing.h"
#include "field/field_job.h"
#include "field/host_inside.h"
#include "field/host_sites.h"
#include "medial/distance_field.h"
#include "medial/ranks.h"
#include "ranks/counting_communicator.h"
#include "ranks/surface/distributed_surface.h"
#include "ranks/surface/shared_sign.h"
#include "ranks/surface/shared_tree.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace medial
{

/// A surface in pieces, as a rank sees it: brings what can be closest in a part of the grid, where
/// the rank can then compute by itself.
class RankField
{
public:
  /// Every rank calls it.
  /// @param statistics must outlive this.
  /// @throws Error as computeDistanceField(), on every rank.
  RankField(Communicator& communicator, const SurfacePiece& piece, const Grid& grid,
    const DistanceFieldOptions& options, const Run& run, RunStatistics& statistics);

  /// Brings what can be closest in a part of the grid, instead of what was here. Every rank calls
  /// it; what follows needs it.
  /// @param searched where closest places will be asked for; may be empty.
  /// @param computed where the field will be, with its sign; may be empty.
  void bring(Communicator& communicator, const Extent& searched, const Extent& computed);

  /// The same with boxes, in local coordinates, where closest places will be asked for.
  void bring(Communicator& communicator, const std::vector<FrameBox>& boxes,
    const Extent& computed);

  /// Drops what compute() and tryWork() do not need. Nothing else must be called after it but what
  /// tells numbers.
  void settle();

  /// Computes the field of an extent within the part. It has the numbers that sites have in the
  /// whole surface.
  void compute(const Extent& extent, FieldSink& sink);
  /// Computes the distances of an extent within the part for what that takes alone: returns the
  /// numbers of tests, pairs and evaluations. It starts at a tile, and pseudonormals give no sign.
  std::int64_t tryWork(const Extent& extent);
  /// As compute(), and selects crossings, which have the sites of the part. There may be more of
  /// them, up to eight grid points before the extent.
  std::vector<Crossing> select(const Extent& extent, const CrossingSelection& selection,
    FieldSink& sink);

  const DistributedSurface& surface() const { return surface_; }
  const GridFrame& frame() const { return frame_; }
  FieldSign sign() const { return sign_.fieldSign(); }
  bool hasSign() const { return this->sign() != FieldSign::None; }
  const SharedSign& sharedSign() const { return sign_; }
  /// Points inside the part where the field is computed; null where winding numbers give no sign.
  const InsideRows* insideRows() const { return inside_ ? &inside_->rows() : nullptr; }
  /// Lets sharedSign() have the lids of holes. Every rank calls it.
  void closeHoles(Communicator& communicator) { sign_.close(communicator); }
  /// Largest number of triangles that were brought here at once.
  std::int64_t heldTriangles() const { return heldTriangles_; }
  /// Number of triangles in the rank's share.
  std::int64_t ownTriangles() const { return ownTriangles_; }
  /// Triangles that are here, with their neighbours.
  const SurfacePart& part() const { return near_->part; }
  const SiteSet& sites() const { return host_->sites(); }
  /// Exact closest points in the part.
  const SiteQuery& query() const { return host_->query(); }
  /// Returns the numbers of the part's sites in the whole surface.
  std::vector<std::int32_t> siteNumbers() const { return near_->part.siteNumbers(surface_); }

private:
  FieldJob job(const Extent& extent);

  Grid grid_;
  Extent whole_;
  std::size_t memoryMiB_;
  Run run_;
  RunStatistics& statistics_;
  DistributedSurface surface_;
  GridFrame frame_;
  SharedSign sign_;
  std::optional<SharedTree> tree_;
  std::int64_t ownTriangles_;
  std::int64_t heldTriangles_ = 0;
  std::optional<HostInside> inside_; ///< with winding numbers
  std::optional<NearSurface> near_;
  std::optional<HostSites> host_;
};

/// Returns what a rank has held and sent so far.
RankCounts countsOf(const RankField& field, const CountingCommunicator& communicator);

/// @throws Error InvalidInput for a grid, an extent or options that a surface in pieces cannot
/// have.
void checkFieldOfRanks(const Grid& grid, const Extent& extent, const DistanceFieldOptions& options);

} // namespace medial
