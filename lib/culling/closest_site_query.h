#pragma once

#include "medial/culling/candidate_filter.h"
#include "medial/sites/closest_point.h"

#include <glm/glm.hpp>

#include <vector>

namespace medial
{

/// The exact closest surface point of each of the given points (frame coordinates), in double
/// precision, for points anywhere: the points are halved recursively, and every half keeps the
/// candidates of its bounding box. Runs on all threads of the current arena.
std::vector<SitePoint> closestSites(const SiteSet& sites, const CandidateFilter& filter,
  const std::vector<glm::dvec3>& points);

} // namespace medial
