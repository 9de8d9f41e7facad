#pragma once

#include "base/run.h"
#include "field/crossing.h"
#include "field/field_engine.h"
#include "field/host_inside.h"
#include "field/host_sites.h"
#include "medial/distance_field.h"
#include "sign/inside_query.h"
#include "sign/sign_choice.h"
#include "sites/grid_frame.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace medial
{

/// Computes the field of a mesh: checks the input, builds the sites and runs an engine.
class FieldPipeline
{
public:
  /// Checks everything that can be checked before the work starts.
  /// @param mesh, connectivity must outlive this.
  /// @param orienter of the mesh, whose points may have been elsewhere.
  /// @param run replaces options.execution.
  /// @throws Error as computeDistanceField.
  FieldPipeline(const TriangleMesh& mesh, const MeshConnectivity& connectivity, const Grid& grid,
    const Extent& extent, const DistanceFieldOptions& options, SurfaceOrienter& orienter,
    const Run& run);

  /// The method used, never Auto.
  SignMethod sign() const { return sign_->report().method; }
  /// Per triangle 1 if it faces outwards as it is, or -1. Empty without a sign.
  const std::vector<std::int8_t>& directions() const { return sign_->directions(); }
  const GridFrame& frame() const { return frame_; }
  /// Makes what tells inside from outside at any position, local coordinates.
  InsideQuery insideQuery() const;
  RunStatistics& statistics() { return statistics_; }

  /// Computes the field.
  void run(FieldEngine& engine, FieldSink& sink);

  /// Computes the field and selects the grid edges that the medial axis crosses.
  std::vector<Crossing> run(FieldEngine& engine, FieldSink& sink,
    const CrossingSelection& selection);

  /// Available after a run.
  const SiteSet& sites() const { return host_->sites(); }
  /// Exact closest points. Available after a run.
  const SiteQuery& query() const { return host_->query(); }
  /// Frees memory that a field takes, and queries don't.
  void forgetField() { host_->forgetFilter(); }

private:
  FieldJob prepare(const FieldEngine& engine);

  const TriangleMesh& mesh_;
  const MeshConnectivity& connectivity_;
  Extent whole_;
  Extent extent_;
  std::size_t memoryMiB_;
  bool verify_;
  Run run_;
  GridFrame frame_;
  std::optional<SignChoice> sign_;
  RunStatistics statistics_;
  std::optional<HostInside> inside_;
  std::optional<HostSites> host_;
};

} // namespace medial
