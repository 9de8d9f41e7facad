#pragma once

#include "proximity_command.h"
#include "proximity_results.h"

#include <string>

namespace medial::app
{

/// Prints a table on standard output: a row for each pair in each frame.
void printTable(const ProximityCommand& command, const ProximityResults& results);

/// @return JSON text with the keys meshes [{path, triangles, vertices, closed, frames}], frames and
///   seconds {read, compute}. A frame is {frame, pairs, seconds}. A pair is {a, b, separation,
///   witness_a, witness_b, cell_a, cell_b, intersect, collide, inside_undefined, depth,
///   depth_at_most, deepest_point, translational_depth [lower, upper], separating_translation,
///   contacts, seconds}, where a and b are indices into meshes. A contact is {point, normal, depth,
///   manifold, cell_a, cell_b}. Lengths are in world units. What was not computed or is not known
///   is null.
std::string makeJson(const ProximityCommand& command, const ProximityResults& results);

} // namespace medial::app
