#pragma once

#include "distance_command.h"
#include "distance_results.h"

#include <string>

namespace medial::app
{

/// Prints a table on standard output.
void printTable(const DistanceCommand& command, const DistanceResults& results);

/// @return JSON text with the keys mesh {path, triangles, vertices}, points {path, count}, sign
///   {method, reason}, distance {min, max, mean, rms, median, percentile_95, inside}, hausdorff and
///   seconds {read, compute}. Lengths are in world units; mean, rms, median and percentile_95 are
///   those of the magnitudes; inside is the number of points with a negative distance. hausdorff is
///   {distance, points_to_mesh, mesh_to_points}, each of the last two {distance, bound, point};
///   null if POINTS has no cells.
std::string makeJson(const DistanceCommand& command, const DistanceResults& results);

} // namespace medial::app
