#pragma once

#include "field/field_engine.h"
#include "medial/compute_distance_field.h"
#include "medial/compute_medial_axis.h"

#include <memory>

namespace medial
{

/// Does the work of computeDistanceField() for one of several frames.
/// @param engine of the previous frame, over the same mesh in other positions; null for the first
///   frame. Replaced if the options ask for another kind.
RunStatistics computeField(const TriangleMesh& mesh, const MeshConnectivity& connectivity,
  const Grid& grid, const Extent& extent, FieldSink& sink, const DistanceFieldOptions& options,
  std::unique_ptr<FieldEngine>& engine);

/// Does the work of computeMedialAxis() for one of several frames, with the engine as for
/// computeField().
MedialAxis computeAxis(const TriangleMesh& mesh, const MeshConnectivity& connectivity,
  const Grid& grid, const MedialAxisOptions& options, FieldSink& sink,
  std::unique_ptr<FieldEngine>& engine);

} // namespace medial
