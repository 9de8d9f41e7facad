#pragma once

#include "medial/execution.h"
#include "medial/export.h"
#include "medial/medial_model.h"
#include "medial/triangle_mesh.h"

#include <cstdint>

namespace medial
{

/// What of a surface a medial axis accounts for.
struct AxisCoverage
{
  /// Share of the surface's area that is farther than `reach` from the union of the axis's balls,
  /// cones and wedges, in [0, 1]. What is inside the union counts as covered.
  double uncoveredShare = 0.0;
  double reach = 0.0;       ///< world units
  std::int64_t samples = 0; ///< that the share is of
  double seconds = 0.0;     ///< wall-clock
};

/// Default number of samples: they are spread evenly, so that the share is right to about 0.001.
constexpr std::int64_t kDefaultCoverageSamples = 20000;

/// How coverage is measured.
struct CoverageOptions
{
  /// Number of samples on the surface, in [1000, 100000000].
  std::int64_t samples = kDefaultCoverageSamples;
  Execution execution; ///< threads, progress and cancelling
};

/// How much of a surface the axis of its interior does not account for: parts that the selection or
/// the grid has lost, and the flanks of edges that bend less than theta. It says little of other
/// axes, since no ball outside touches what is convex. The result depends neither on the number of
/// threads nor on chance.
/// @param model may have no balls, which cover nothing; a mesh without area has nothing to cover.
/// @param reach world units, >= 0; one voxel's diagonal suits an axis from a grid, whose sheets end
///   up to that far before the places that they lead to.
/// @throws Error InvalidInput for a negative reach, and as checkMedialModel() and for a number of
///   samples or threads outside its range; Cancelled.
MEDIAL_EXPORT AxisCoverage measureCoverage(const TriangleMesh& mesh, const MedialModel& model,
  double reach, const CoverageOptions& options = {});

} // namespace medial
