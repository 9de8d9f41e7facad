#pragma once

#include "medial/mesh_connectivity.h"
#include "sites/site_set.h"

#include <glm/glm.hpp>

#include <vector>

namespace medial
{

/// Where sheets or curves of the medial axis reach the surface, so that medial balls shrink to
/// nothing there.
struct SharpFeatures
{
  /// Per point of the mesh, whether it is the end of a sharp edge or a sharp tip, such as that of a
  /// cone, with equally steep faces on opposite sides.
  std::vector<char> points;
  /// Edges, ascending, that are convex seen from the side and whose faces' normals are far apart.
  std::vector<int> edges;
};

/// @param inward per point of the mesh, the unit direction into the side; zero if there is none.
/// @param sign 1 if `inward` is against the faces' own normals, otherwise -1.
/// @param angle between the normals, degrees: from here on a feature is sharp.
SharpFeatures sharpFeatures(const SiteSet& sites, const MeshConnectivity& connectivity,
  const std::vector<glm::dvec3>& inward, double sign, double angle);

} // namespace medial
