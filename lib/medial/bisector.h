#pragma once

#include "medial/culling/tile_query.h"
#include "medial/medial/crossing.h"
#include "medial/sites/site_set.h"

#include <glm/glm.hpp>

#include <vector>

namespace medial
{

/// Where crossed grid edges meet the bisector of two sites: per crossing a point of the edge at
/// equal distance from both (frame coordinates).
///
/// Where a third site is nearer there than the two, the crossing changes to the pair of this site
/// with either of them, whichever has the larger separation angle; `crossings` are updated. Those
/// that meet the surface itself, where an edge grazes it and the field is unsigned, are removed.
std::vector<glm::dvec3> bisectorPoints(const SiteSet& sites, const GridFrame& frame,
  const TileQuery& query, std::vector<Crossing>& crossings);

} // namespace medial
