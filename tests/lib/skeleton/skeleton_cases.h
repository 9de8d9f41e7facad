#pragma once

#include "medial/compute_medial_axis.h"
#include "medial/skeleton.h"
#include "medial/triangle_mesh.h"

#include "support/tubes.h"

#include <vector>

// Solids of tubes, and skeletons as the tests make them.
namespace medial::test
{

/// Turned away from the directions of the grid.
TriangleMesh askew(const TriangleMesh& mesh);

/// Tubes from the origin in directions of the plane, degrees.
std::vector<Tube> star(const std::vector<double>& directions, double length, double radius);

/// A ring with spokes.
std::vector<Tube> wheel(int spokes, double ring, double radius);

/// With the topology preserved.
MedialAxis axisOf(const TriangleMesh& mesh, int resolution, double angle = kDefaultAngle);

Skeleton skeletonOf(const TriangleMesh& mesh, int resolution, double minBranch = kDefaultMinBranch);

} // namespace medial::test
