#pragma once

#include "medial/mesh_connectivity.h"
#include "medial/triangle_mesh.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <vector>

namespace medial
{

/// Pieces of a surface that are connected through edges of two triangles, each with one direction.
struct Patches
{
  std::vector<int> ofTriangle;             ///< -1 for the copy of an earlier triangle
  std::vector<int> originals;              ///< per triangle: the one it is a copy of, or itself
  std::vector<std::int8_t> senses;         ///< per triangle: 1 as it is, -1 turned round
  std::vector<std::vector<int>> triangles; ///< of every patch, ascending
};

/// Splits a mesh into patches. Triangles with the corners of an earlier one are left out. A patch
/// has the direction of its first triangle. One that cannot have a direction, such as a Moebius
/// strip, has rims on both sides of a cut. Positions do not matter.
Patches findPatches(const TriangleMesh& mesh, const MeshConnectivity& connectivity);

/// Returns the patches against whose directions most of their area runs.
/// @param points of the mesh, relative to its middle.
std::vector<bool> runningBackwards(const Patches& patches, const TriangleMesh& mesh,
  const std::vector<glm::dvec3>& points);

/// Returns 1 if a triangle runs along an edge in the direction in which the edge is stored, or -1.
int directionAlong(const TriangleMesh& mesh, const MeshConnectivity& connectivity, int triangle,
  int edge);

} // namespace medial
