#pragma once

#include "base/checkpoint.h"
#include "medial/mesh_connectivity.h"
#include "medial/triangle_mesh.h"
#include "thickness/place_values.h"

namespace medial
{

/// Gives places without a value that of a wall nearby, along the edges of the mesh, from the
/// corners of triangles to their centres, and from centre to centre, but not beyond edges where the
/// solid opens (PlaceValues::opens): the base that a rib stands on is no part of the rib. The strip
/// without a value beside a wall is at most half as wide as the wall is thick, and half of the
/// wall's narrow side is as wide again. What is within both belongs to the nearest such wall, what
/// is up to one and a half thicknesses away to the one that is the fewest of its own away. Of
/// several at the same distance the first point, then the first triangle counts. All else has no
/// wall, and stays as it is.
/// @param points, triangles values at points and at the centres of triangles.
void extendWalls(const TriangleMesh& mesh, const MeshConnectivity& connectivity,
  const Checkpoint& checkpoint, PlaceValues& points, PlaceValues& triangles);

} // namespace medial
