#pragma once

#include "methods/published_bounds.h"

#include "field/engines/rasteriser/atlas_layout.h"
#include "sites/grid_frame.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <vector>

namespace medial::benchmark
{

/// A corner of a polygon.
struct PolygonVertex
{
  glm::vec2 position; ///< atlas pixels; pixel centres are grid points
  glm::vec3 distance; ///< vector to the site, affine in the position; local units
  std::int32_t site;
};

/// Triangulated polygons of consecutive sites.
struct PolygonChunk
{
  std::vector<PolygonVertex> vertices;
  std::vector<std::uint32_t> indices; ///< into this chunk's vertices, three a triangle
  std::int64_t polygons = 0;
  double area = 0.0; ///< in grid points
};

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
