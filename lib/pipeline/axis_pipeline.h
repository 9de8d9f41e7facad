#pragma once

#include "field/field_memory.h"
#include "medial/compute_medial_axis.h"

namespace medial
{

/// computeMedialAxis() with what is left from an earlier frame.
/// @param memory may be null.
MedialAxis computeMedialAxis(const TriangleMesh& mesh, const MeshConnectivity& connectivity,
  const Grid& grid, const MedialAxisOptions& options, const FieldArrays& arrays,
  FieldMemory* memory);

} // namespace medial
