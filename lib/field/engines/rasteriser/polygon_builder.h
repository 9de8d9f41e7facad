#pragma once

#include "culling/candidate_tiles.h"
#include "field/engines/rasteriser/atlas_layout.h"
#include "sites/site_bounds.h"
#include "sites/site_set.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <vector>

namespace medial
{

/// Input of distance_field.vert.
struct PolygonVertex
{
  glm::vec2 position; ///< atlas pixels
  glm::vec3 distance; ///< vector to the site, in the site's own axes; local units
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

/// Builds the polygons of a slab: for every slice and every site that may be closest there, the
/// part of the slice inside the candidate tiles and half-spaces of the site (section 3.2 of the
/// paper, with the bounds of SiteBounds). Sites are in ascending order on each slice, so that ties
/// go to the lowest id.
/// @param slab the extent that the tiles cover; slice slab.min[2] goes to slot 1 of the atlas.
std::vector<PolygonChunk> buildPolygons(const SiteSet& sites, const SiteBounds& bounds,
  const GridFrame& frame, const std::vector<CandidateTiles>& tiles, const Extent& slab,
  const AtlasLayout& atlas);

} // namespace medial
