#pragma once

#include "options.h"
#include "result.h"

#include "medial/axis_coverage.h"
#include "medial/execution.h"
#include "medial/grid.h"
#include "medial/mesh_connectivity.h"
#include "medial/side.h"
#include "medial/triangle_mesh.h"

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

// How much of the surface the axis describes: when and how exactly that is measured, and what the
// user is told.
namespace medial::app
{

/// A note tells the user if the axis leaves out this share of the surface or more.
constexpr double kNoticeableShare = 0.01;

/// Measures what a report states. Only for the note in the summary, a bound on fewer samples is
/// enough unless the share may be noticeable.
/// @param measure measures with a number of samples and a negligible share.
AxisCoverage coverageFor(const Options& options,
  const std::function<AxisCoverage(std::int64_t samples, double negligible)>& measure);

/// Whether coverage is to be measured, for a report or a note.
bool wantsCoverage(const Options& options, Side side);

/// How far the axis may be from the surface that counts as covered: a voxel's diagonal.
double coverageReach(const Grid& grid);

/// Thickness along rays at the middles of the cells nearest to places.
std::vector<double> thicknessAt(const std::vector<UncoveredPlace>& places, const TriangleMesh& mesh,
  const MeshConnectivity& connectivity, const Execution& execution);

/// The grid's spacing that catches the walls that its own misses at the uncovered places; nothing
/// if it is fine enough for them, or if the options leave them out at any spacing.
std::optional<double> catchingSpacing(const Result& result, const Options& options);

} // namespace medial::app
