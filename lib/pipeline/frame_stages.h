#pragma once

#include "field/mesh_state.h"
#include "medial/compute_distance_field.h"
#include "medial/compute_medial_axis.h"

namespace medial
{

/// Does the work of computeDistanceField() for one of several frames.
/// @param state of the frames before, over the same mesh in other positions. Its engine is replaced
///   if the options ask for another kind.
RunStatistics computeField(const TriangleMesh& mesh, const MeshConnectivity& connectivity,
  const Grid& grid, const Extent& extent, FieldSink& sink, const DistanceFieldOptions& options,
  MeshState& state);

/// Does the work of computeMedialAxis() for one of several frames, with the state as for
/// computeField().
MedialAxis computeAxis(const TriangleMesh& mesh, const MeshConnectivity& connectivity,
  const Grid& grid, const MedialAxisOptions& options, FieldSink& sink, MeshState& state);

} // namespace medial
