#pragma once

#include "medial/mesh_connectivity.h"
#include "sites/site_set.h"

#include <glm/glm.hpp>

#include <vector>

namespace medial
{

/// Finds the points of the mesh where sheets or curves of the medial axis reach the surface, so
/// that medial balls shrink to nothing there. These are the ends of edges that are convex seen from
/// the side and whose faces' normals are `angle` or more apart, and tips, such as that of a cone,
/// with equally steep faces on opposite sides.
///
/// @param inward per point of the mesh, the unit direction into the side; zero if there is none.
/// @param sign 1 if `inward` is against the faces' own normals, otherwise -1.
/// @param angle degrees.
/// @return per point of the mesh, whether it is sharp.
std::vector<char> sharpPoints(const SiteSet& sites, const MeshConnectivity& connectivity,
  const std::vector<glm::dvec3>& inward, double sign, double angle);

} // namespace medial
