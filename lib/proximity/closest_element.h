#pragma once

#include "proximity/moving_mesh.h"

#include <glm/glm.hpp>

#include <limits>

namespace medial
{

/// The point of a mesh closest to a position, and the slot of its element.
struct ClosestElement
{
  double squared = std::numeric_limits<double>::infinity(); ///< distance
  glm::dvec3 point{ 0.0 };
  int slot = -1;
};

/// Finds the point of a mesh closest to a position.
/// @param hint slot of an element that may be near; -1 for none. It does not change the result.
ClosestElement closestElement(const MovingMesh& mesh, const glm::dvec3& x, int hint = -1);

} // namespace medial
