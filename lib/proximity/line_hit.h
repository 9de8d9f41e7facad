#pragma once

#include "proximity/moving_mesh.h"

#include <glm/glm.hpp>

namespace medial
{

/// Returns how far from a position a half-line first meets a triangle of a mesh; infinity if it
/// meets none. To rounding: a line through an edge may slip through.
/// @param direction unit vector.
double firstHit(const MovingMesh& mesh, const glm::dvec3& from, const glm::dvec3& direction);

} // namespace medial
