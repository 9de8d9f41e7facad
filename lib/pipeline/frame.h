#pragma once

#include "field/field_engine.h"
#include "medial/compute_medial_axis.h"
#include "medial/distance_field.h"

#include <memory>

namespace medial
{

/// computeDistanceField() for one of several frames.
/// @param engine of the frame before, over the same mesh in other positions; null before the first.
///   Replaced where the options want another.
RunStatistics computeField(const TriangleMesh& mesh, const MeshConnectivity& connectivity,
  const Grid& grid, const Extent& extent, FieldSink& sink, const DistanceFieldOptions& options,
  std::unique_ptr<FieldEngine>& engine);

/// computeMedialAxis() for one of several frames, with the engine as for computeField().
MedialAxis computeAxis(const TriangleMesh& mesh, const MeshConnectivity& connectivity,
  const Grid& grid, const MedialAxisOptions& options, FieldSink& sink,
  std::unique_ptr<FieldEngine>& engine);

} // namespace medial
