#pragma once

#include "medial/mesh_connectivity.h"
#include "medial/triangle_mesh.h"

#include <cstdint>
#include <vector>

namespace medial
{

/// Number of elements in a group.
constexpr int kGroupSize = 8;

/// Orders the elements of a mesh (its faces, and edges and vertices of no face, by the sites that
/// name them) so that neighbours are close together: along Hilbert's curve. Eight in a row make a
/// group, and any 8^k from a multiple of 8^k on a node of a tree. Elements much larger than most
/// come last, with groups of their own, since they would widen those of others.
///
/// @return the sites, a multiple of kGroupSize; -1 where a group has room left.
std::vector<std::int32_t> orderElements(const TriangleMesh& mesh,
  const MeshConnectivity& connectivity);

} // namespace medial
