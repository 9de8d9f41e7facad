#pragma once

#include "methods/published_bounds.h"

#include "field/engines/rasteriser/atlas_layout.h"
#include "field/engines/rasteriser/polygon_builder.h"

#include <vector>

namespace medial::benchmark
{

/// Consecutive slices that are drawn together, from slot 1 of the atlas on.
struct SliceBatch
{
  int first = 0;
  std::vector<double> reach; ///< for each slice, no distance on it is larger; local units
};

/// For every slice and every bound whose site the slice's points can reach: the intersection, with
/// distance vectors at its corners. In ascending order of slices and, on each, of sites.
std::vector<PolygonChunk> publishedPolygons(const SiteSet& sites, const PublishedBounds& bounds,
  const GridFrame& frame, const AtlasLayout& atlas, const SliceBatch& batch);

} // namespace medial::benchmark
