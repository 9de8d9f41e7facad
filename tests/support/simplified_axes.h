#pragma once

#include "medial/compute_medial_axis.h"
#include "medial/triangle_mesh.h"

#include <cstdint>

// Axes to simplify, and simplified ones.
namespace medial::test
{

/// With default options.
MedialAxis simplified(const MedialAxis& axis, std::int64_t maxSpheres);

/// Of a mesh, on offCentreGrid(); the angle in degrees.
MedialAxis axisOf(const TriangleMesh& mesh, double spacing, std::int64_t maxSpheres = 0,
  double angle = 60.0);

/// 24 x 24 quads of radius 0.4 over a rectangle of 3 x 2 with a corner at (1, 2, 3).
MedialAxis plate();

/// The triangles of an icosphere of radius R about the origin.
MedialAxis sphereSheet(double R, double radius);

/// Distance from a point to the nearest one of an axis.
double nearest(const MedialAxis& axis, const Point3& point);

} // namespace medial::test
