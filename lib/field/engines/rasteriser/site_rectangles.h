#pragma once

#include "culling/candidate_tiles.h"

#include <glm/glm.hpp>

#include <vector>

namespace medial
{

/// The grid points of one layer of leaf tiles that a site's polygons are to cover: the bounding box
/// of the tiles that list the site, or a part of it no longer than 64 points. Both ends included.
struct SiteRectangle
{
  int site;
  glm::ivec3 low;
  glm::ivec3 high;
};

/// Gathers the tiles of a slab into rectangles: layer by layer, sites ascending within a layer.
std::vector<SiteRectangle> siteRectangles(const std::vector<CandidateTiles>& tiles,
  const Extent& slab, int siteCount);

} // namespace medial
