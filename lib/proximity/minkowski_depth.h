#pragma once

#include "proximity/moving_mesh.h"

#include <glm/glm.hpp>

namespace medial
{

/// How deep the convex hulls of two meshes are in each other: the shortest translation of A that
/// separates them, between two bounds.
struct HullDepth
{
  double lower = 0.0;
  double upper = 0.0;
  glm::dvec3 direction{ 0.0 }; ///< unit vector: A moved by `upper` along it is apart from B
};

/// Expands a polytope inside the Minkowski difference of the hulls, B - A, where the origin is
/// nearest to its border (van den Bergen 2001). The bounds meet up to rounding.
HullDepth hullDepth(const MovingMesh& a, const MovingMesh& b);

/// Whether a mesh is the surface of a convex solid: no point is above the plane of a triangle by
/// more than 2e-10 of its size.
bool isConvex(const MovingMesh& mesh);

} // namespace medial
