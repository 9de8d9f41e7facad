#pragma once

#include "base/checkpoint.h"
#include "culling/candidate_tiles.h"
#include "culling/closest_seeds.h"
#include "culling/tile_query.h"
#include "field/field_job.h"

#include <memory>
#include <vector>

namespace medial
{

/// Finds the candidates of a job, slab by slab, for engines that cull on the host. Adds seconds and
/// pairs to the statistics of the job.
///
/// Tiles and their candidates do not depend on the slabs: slabs thinner than a layer of blocks
/// share the tiles of the layer.
class SlabCulling
{
public:
  using Tiles = std::vector<CandidateTiles>;

  /// @param hull with TileHull::Cells the tiles are kept, for queries between grid points.
  /// @param seeds of an earlier job; must outlive this.
  SlabCulling(const FieldJob& job, TileHull hull, const ClosestSeeds& seeds);

  /// For visiting the tiles of a slab without listing them.
  const CandidateHierarchy& hierarchy() const { return hierarchy_; }

  /// Lists the leaf tiles of the layers of blocks that contain a slab, in one list per block. Slabs
  /// come in ascending z.
  std::shared_ptr<const Tiles> tilesOf(const Extent& slab, const Checkpoint& checkpoint);

  /// Gives away the query over all slabs listed so far; null with TileHull::Points.
  std::unique_ptr<TileQuery> takeQuery() { return std::move(query_); }

private:
  const FieldJob& job_;
  CandidateHierarchy hierarchy_;
  Extent layers_; ///< of the last slab
  std::shared_ptr<const Tiles> tiles_;
  std::unique_ptr<TileQuery> query_;
};

} // namespace medial
