#pragma once

#include "proximity/moving_mesh.h"

#include <glm/glm.hpp>

namespace medial
{

/// Where one mesh last touches another as it moves away in a straight line.
struct LastContact
{
  double distance = 0.0;    ///< that A has moved; 0 if it never touches B
  glm::dvec3 normal{ 0.0 }; ///< unit normal of the two surfaces there, along the direction
};

/// Moves A along a direction and returns the last contact with B, to rounding.
/// @param direction unit vector.
/// @param limit where A has moved farther than this the answer does not matter: any contact beyond
///   it ends the search.
LastContact lastContact(const MovingMesh& a, const MovingMesh& b, const glm::dvec3& direction,
  double limit);

} // namespace medial
