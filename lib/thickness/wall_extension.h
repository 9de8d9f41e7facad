#pragma once

#include "base/checkpoint.h"
#include "medial/mesh_connectivity.h"
#include "medial/triangle_mesh.h"
#include "thickness/place_values.h"

namespace medial
{

/// Gives places without a value that of the nearest place with one, along the edges of the mesh and
/// from the corners of triangles to their centres. Distances count in multiples of the thickness
/// that is passed on: strips without a value are as wide as the wall beside them is thick. Of
/// several at the same distance the first point, then the first triangle counts. Pieces of the mesh
/// without any value stay as they are.
/// @param points, triangles values at points and at the centres of triangles.
void extendWalls(const TriangleMesh& mesh, const MeshConnectivity& connectivity,
  const Checkpoint& checkpoint, PlaceValues& points, PlaceValues& triangles);

} // namespace medial
