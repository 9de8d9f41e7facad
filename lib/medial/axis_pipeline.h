#pragma once

#include "medial/distance/field_memory.h"
#include "medial/medial/medial_axis.h"

namespace medial
{

/// computeMedialAxis() with what is left from an earlier frame.
/// @param memory may be null.
MedialAxis computeMedialAxis(const TriangleMesh& mesh, const MeshTopology& topology,
  const Grid& grid, const MedialAxisOptions& options, const FieldArrays& arrays,
  FieldMemory* memory);

} // namespace medial
