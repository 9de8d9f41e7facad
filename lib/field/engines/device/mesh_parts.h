#pragma once

#include "medial/mesh_connectivity.h"
#include "medial/triangle_mesh.h"

#include <cstdint>
#include <vector>

namespace medial
{

/// Some elements of a mesh as a mesh of their own, and what its points and sites are called in the
/// whole one.
struct MeshPart
{
  TriangleMesh mesh;
  MeshConnectivity connectivity;
  std::vector<int> points;         ///< of the whole mesh, by those of the part
  std::vector<std::int32_t> sites; ///< of the whole mesh, by those of the part
};

/// Splits a mesh into parts of neighbouring elements: every element is in one of them, edges and
/// vertices where parts meet in several.
/// @param elements of a part at most, > 0.
std::vector<MeshPart> splitMesh(const TriangleMesh& mesh, const MeshConnectivity& connectivity,
  int elements);

} // namespace medial
