#pragma once

#include "culling/discs.h"
#include "culling/shared_sites.h"
#include "culling/site_group.h"
#include "sites/site_set.h"

#include <glm/glm.hpp>

#include <limits>
#include <vector>

namespace medial
{

/// The disc of one node of a tree of elements, before it is rounded to single precision.
struct NodeDisc
{
  static constexpr double kNoCone = std::numeric_limits<double>::infinity();

  glm::dvec3 centre{ 0.0 };
  glm::dvec3 normal{ 0.0 };
  double radius = 0.0;
  double halfHeight = 0.0;
  double cone = kNoCone; ///< largest angle between its normal and those of the faces at its sites
};

/// Returns the disc around a group.
NodeDisc discOf(const SiteSet& sites, const SharedSites& shared, const SiteGroup& group);

/// Packs discs by eights, and replaces them by one around each eight. Uses the threads of the
/// current arena.
/// @param slack by which discs are widened.
std::vector<Discs> packed(std::vector<NodeDisc>& discs, float slack);

} // namespace medial
