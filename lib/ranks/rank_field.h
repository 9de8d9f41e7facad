#pragma once

#include "base/run.h"
#include "field/crossing.h"
#include "field/field_job.h"
#include "field/host_inside.h"
#include "field/host_sites.h"
#include "medial/distance_field.h"
#include "medial/ranks.h"
#include "ranks/counting_communicator.h"
#include "ranks/distributed_surface.h"
#include "ranks/shared_sign.h"
#include "ranks/shared_tree.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace medial
{

/// The surface near a part of the grid, and the field there: what a rank can compute by itself once
/// it has what can be closest.
class RankField
{
public:
  /// Every rank calls it.
  /// @param searched where closest places will be asked for; may be empty.
  /// @param computed where the field will be; may be empty.
  /// @param statistics must outlive this.
  /// @throws Error as computeDistanceField(), on every rank.
  RankField(Communicator& communicator, const SurfacePiece& piece, const Grid& grid,
    const Extent& searched, const Extent& computed, const DistanceFieldOptions& options,
    const Run& run, RunStatistics& statistics);

  /// Computes the field of an extent within the part. It has the numbers that sites have in the
  /// whole surface.
  void compute(const Extent& extent, FieldSink& sink);
  /// Computes the field of an extent within the part, and returns the work that it took: numbers of
  /// tests, pairs and evaluations.
  std::int64_t tryWork(const Extent& extent);
  /// As compute(), and selects crossings, which have the sites of the part. There may be more of
  /// them, up to eight grid points before the extent.
  std::vector<Crossing> select(const Extent& extent, const CrossingSelection& selection,
    FieldSink& sink);

  const DistributedSurface& surface() const { return surface_; }
  const GridFrame& frame() const { return frame_; }
  FieldSign sign() const { return sign_.fieldSign(); }
  const SharedSign& sharedSign() const { return sign_; }
  /// Lets sharedSign() have the lids of holes. Every rank calls it.
  void closeHoles(Communicator& communicator) { sign_.close(communicator); }
  /// Triangles that are here, with their neighbours.
  const SurfacePart& part() const { return near_->part; }
  const SiteSet& sites() const { return host_->sites(); }
  /// Exact closest points in the part.
  const SiteQuery& query() const { return host_->query(); }
  /// Returns the numbers of the part's sites in the whole surface.
  std::vector<std::int32_t> siteNumbers() const { return near_->part.siteNumbers(surface_); }

private:
  FieldJob job(const Extent& extent);

  Extent whole_;
  std::size_t memoryMiB_;
  Run run_;
  RunStatistics& statistics_;
  DistributedSurface surface_;
  GridFrame frame_;
  SharedSign sign_;
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
