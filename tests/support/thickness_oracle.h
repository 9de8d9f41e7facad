#pragma once

#include "medial/triangle_mesh.h"
#include "support/mesh_search.h"

#include <vector>

// Thickness by brute force, in double precision; shares no code with the library.
namespace medial::test
{

/// Angle-weighted pseudonormals of the points of a mesh, by the orientation of its triangles; zero
/// where they cancel out.
std::vector<Point3> pointNormals(const TriangleMesh& mesh);

/// Follows the ray from a point in small steps, with the closest of all triangles at each, to the
/// first step whose closest point is seen under `angle` (degrees) or more away from the start, and
/// refines the step. Above 60 degrees the ball there must touch the start: the distance is at least
/// 0.95 times the way so far, or that share of what it is right at the start, on edges, or where
/// 60 degrees are seen first, on tessellated surfaces.
/// @param direction of unit length.
/// @param firstStep where to begin; every step is 1 % of the way so far.
/// @return twice the distance to the mesh there; NaN where there is no such place.
double thicknessByBruteForce(const MeshSearch& search, const Point3& start, const Point3& direction,
  double angle, double firstStep);

} // namespace medial::test
