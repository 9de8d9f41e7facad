#pragma once

#include "base/checkpoint.h"
#include "medial/point_distance.h"
#include "medial/triangle_mesh.h"
#include "query/distance_query.h"

namespace medial
{

/// @throws Error InvalidInput if it is outside (0, 1).
void checkTolerance(double tolerance);

/// See PointDistance::farthest(). Uses the threads of the current arena.
FarthestPoint farthestPoint(const DistanceQuery& query, const TriangleMesh& surface,
  double tolerance, const Checkpoint& checkpoint);

} // namespace medial
