#pragma once

#include "culling/site_query.h"
#include "field/engines/rasteriser/slab_renderer.h"

#include <vector>

namespace medial
{

/// Fills grid points of a resolved slab that no polygon covered, by exact queries. The bounds of
/// Voronoi regions overlap, so there should be none; this makes sure of it. GPU thread only.
/// @param normals as SlabRenderer::move() takes them.
/// @param query covers the grid points of the slab.
void repairHoles(SlabRenderer& renderer, const std::vector<glm::vec4>& normals,
  const GridFrame& frame, const SiteQuery& query, const Extent& slab);

} // namespace medial
