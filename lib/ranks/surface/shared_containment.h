#pragma once

#include "medial/ranks.h"
#include "sign/containment.h"

#include <glm/glm.hpp>

#include <vector>

namespace medial
{

/// Returns the solids around each of this rank's places, ascending. Every rank calls it.
/// @param triangles of solids, each on one rank, with the numbers that all ranks have for solids.
std::vector<std::vector<int>> solidsAround(Communicator& communicator,
  const std::vector<SolidTriangle>& triangles, const std::vector<glm::dvec3>& places);

} // namespace medial
