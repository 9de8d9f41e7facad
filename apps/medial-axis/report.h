#pragma once

#include "computation.h"
#include "options.h"

#include <filesystem>
#include <string>

namespace medial::app
{

/// Wall-clock seconds of what the program does around the computation.
struct AppSeconds
{
  double read = 0.0;
  double write = 0.0;
  double total = 0.0;
};

/// The figures of a run; where something was not computed they are 0 or empty.
/// @return JSON text with the keys input {path, triangles, vertices, closed, manifold, components,
///   skipped_degenerate}, grid {dimensions, spacing, origin}, device {renderer, version, software},
///   seconds {read, sites, cull, polygons, draw, resolve, medial, write, total}, counts {sites,
///   polygons, fragments, group_tests, site_tests, candidate_pairs, medial_points, medial_cells},
///   bytes_uploaded, bytes_read_back, dispatches and device_seconds {sites, cull, evaluate,
///   resolve, select, copy, total} of the engine device, fragments_per_voxel, simplification
///   {input_points, input_components, components, joined, forced, dropped, seconds} (as in
///   SimplificationStatistics, 0 without --max-spheres), engine, sign_method, topology {mode, solid
///   (null unless preserved), axis: each {components, euler_characteristic, genus, cavities}},
///   coverage (null unless the axis is that of the interior) {uncovered_share: the share of the
///   surface's area that is farther than reach, the diagonal of a voxel, from the union of the
///   axis's balls, cones and wedges; reach, samples, seconds} and peak_memory_mib; where thickness
///   was computed also thickness {side, angle, min, median, max, share_without, seconds}, whose
///   numbers are null where no point has a thickness. Lengths are in world units.
std::string makeReport(const Result& result, const Options& options, const AppSeconds& seconds);

/// @throws Failure NoSpace if the file cannot be written completely. The message does not name it.
void writeReport(const std::string& report, const std::filesystem::path& file);

} // namespace medial::app
