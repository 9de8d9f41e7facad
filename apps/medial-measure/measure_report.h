#pragma once

#include "measure_command.h"

#include "medial/axis_measurement.h"
#include "medial/mesh_connectivity.h"
#include "medial/triangle_mesh.h"

#include <string>

namespace medial::app
{

/// What was measured, and on what.
struct MeasureResults
{
  TriangleMesh mesh;
  MeshConnectivity connectivity;
  AxisMeasurement measurement;
  double readSeconds = 0.0;
  double measureSeconds = 0.0;
};

/// Prints a table on standard output.
void printTable(const MeasureCommand& command, const MeasureResults& results);

/// @return JSON text with the keys axis {path, points, quads, triangles, lines, vertices,
///   zero_area_cells, components, euler_characteristic}, mesh {path, triangles, vertices, closed,
///   manifold, components, euler_characteristic, diagonal}, surface_to_union {max, mean, samples},
///   union_to_surface {max, mean, samples}, two_sided {hausdorff, mean}, radius_error {max, mean},
///   centres_inside and seconds {read, evaluate}. Distances are in % of the diagonal, which is in
///   world units; centres_inside is a share in [0, 1], null where the mesh has no inside.
std::string makeJson(const MeasureCommand& command, const MeasureResults& results);

} // namespace medial::app
