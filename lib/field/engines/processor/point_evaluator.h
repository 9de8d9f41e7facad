#pragma once

#include "culling/group_list.h"
#include "culling/group_tree.h"
#include "field/tile_field.h"
#include "medial/grid.h"
#include "sites/grid_frame.h"

#include <cstdint>

namespace medial
{

/// Finds closest sites where elements are much smaller than the distance of grid points: each point
/// searches the groups of its brick, starting with the element that is nearest to the point before
/// it.
class PointEvaluator
{
public:
  /// @param tree must outlive this.
  PointEvaluator(const GroupTree& tree, const GridFrame& frame);

  /// Finds the closest sites of a tile.
  /// @param candidates all groups that may hold closest points of the tile.
  /// @param slices of the tile that are needed. Their values do not depend on which these are.
  /// @param brickGroups working memory.
  /// @return number of pairs of a grid point and an element that were evaluated.
  std::int64_t evaluate(const Extent& tile, const GroupList& candidates, const SliceRange& slices,
    TileField& field, GroupList& brickGroups) const;

private:
  std::int64_t evaluateBrick(const Extent& brick, const Extent& tile, const GroupList& groups,
    NearestElement nearest, TileField& field) const;

  const GroupTree& tree_;
  GridFrame frame_;
};

} // namespace medial
