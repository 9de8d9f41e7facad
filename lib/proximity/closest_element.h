#pragma once

#include "base/simd.h"
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

/// As closestElement() for several positions, which is faster if they are near to each other.
/// @param count number of positions, in [1, kDoubleLanes].
/// @param[in,out] found per position: its slot is the hint, and then all of it the result.
void closestElements(const MovingMesh& mesh, const glm::dvec3* positions, int count,
  ClosestElement* found);

} // namespace medial
