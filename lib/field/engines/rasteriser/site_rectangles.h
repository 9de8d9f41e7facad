#pragma once

#include "culling/candidate_tiles.h"

#include <glm/glm.hpp>

#include <vector>

namespace medial
{

/// The grid points of a slab, in one layer of tiles, that the polygons of a site must cover:
/// the bounding box of the tiles that list the site, or a part of it at most 64 points long. Both
/// ends are included.
struct SiteRectangle
{
  int site;
  glm::ivec3 low;
  glm::ivec3 high;
};

/// Gathers the tiles of a slab into rectangles, layer by layer, with sites ascending within a
/// layer.
/// @param tiles of the slab; those beside it do not count.
std::vector<SiteRectangle> siteRectangles(const std::vector<CandidateTiles>& tiles,
  const Extent& slab, int siteCount);

} // namespace medial
