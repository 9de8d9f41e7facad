#pragma once

#include "culling/site_query.h"
#include "field/tile_field.h"
#include "medial/grid.h"
#include "sites/grid_frame.h"

namespace medial
{

/// Finds the sites of grid points by exact queries where single precision does not tell them: far
/// from the surface, and where points are far apart. So it does for points that all bounds exclude;
/// there should be none, and this makes sure of it.
class ExactPoints
{
public:
  ExactPoints(const SiteQuery& query, const GridFrame& frame);

  /// @param slices of the tile that are needed.
  /// @return whether there were such points.
  bool fill(const Extent& tile, const SliceRange& slices, TileField& field) const;

private:
  SiteQuery query_;
  GridFrame frame_;
};

} // namespace medial
