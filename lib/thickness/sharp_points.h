#pragma once

#include "medial/mesh_connectivity.h"
#include "sites/site_set.h"

#include <glm/glm.hpp>

#include <vector>

namespace medial
{

/// Points of the mesh where sheets or curves of the medial axis run into the surface, so that the
/// medial balls shrink to nothing there: ends of edges that are convex seen from the wanted side
/// and whose faces' normals are `angle` or more apart, and tips, such as a cone's, that have faces
/// on opposite sides as steep as that.
///
/// @param inward per point of the mesh, the unit direction into the wanted side; zero where there
///   is none.
/// @param sign 1 where `inward` is against the faces' own normals, else -1.
/// @param angle degrees.
/// @return per point of the mesh, whether it is sharp.
std::vector<char> sharpPoints(const SiteSet& sites, const MeshConnectivity& connectivity,
  const std::vector<glm::dvec3>& inward, double sign, double angle);

} // namespace medial
