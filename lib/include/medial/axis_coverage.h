#pragma once

#include "medial/execution.h"
#include "medial/export.h"
#include "medial/medial_model.h"
#include "medial/triangle_mesh.h"

#include <cstdint>
#include <vector>

namespace medial
{

/// A connected part of the samples that an axis leaves out.
struct UncoveredPlace
{
  Point3 point{};     ///< the sample in its middle
  double share = 0.0; ///< of the surface's area, in [0, 1]
};

/// How much of a surface a medial axis accounts for.
struct AxisCoverage
{
  /// Share of the surface's area, in [0, 1], that lies farther than `reach` from the union of the
  /// axis's balls, cones and wedges. Surface inside the union counts as covered. A share below the
  /// negligible one is an upper bound.
  double uncoveredShare = 0.0;
  /// The largest uncovered parts, at most five, the largest first. Samples closer than twice their
  /// mean spacing belong together. Empty if only a bound was found.
  std::vector<UncoveredPlace> places;
  double reach = 0.0;       ///< the distance asked for, world units
  std::int64_t samples = 0; ///< number of samples on the surface
  double seconds = 0.0;     ///< wall-clock time
};

/// Default number of samples. They are spread evenly, so the share is accurate to about 0.001.
constexpr std::int64_t kDefaultCoverageSamples = 20000;

/// How coverage is measured.
struct CoverageOptions
{
  /// Number of samples on the surface, in [1000, 100000000].
  std::int64_t samples = kDefaultCoverageSamples;
  /// Share below which an upper bound will do, in [0, 1]. Such a bound is found much faster than
  /// the share itself.
  double negligible = 0.0;
  Execution execution; ///< threads, progress and cancelling
};

/// Measures how much of a surface the axis of its interior leaves out: parts that the selection or
/// the grid has lost, and the flanks of edges that bend by less than theta. It says little about
/// axes of the exterior, since no ball outside touches a convex part. The result is the same for
/// every number of threads and every call.
/// @param model may have no balls, and then covers nothing. A mesh without area has nothing to
///   cover.
/// @param reach world units, >= 0. One voxel's diagonal suits an axis computed on a grid: its
///   sheets can end that far from the parts of the surface that they lead to.
/// @throws Error InvalidInput for a negative reach, a number of samples or threads or a negligible
///   share outside its range, and as checkMedialModel(); Cancelled.
MEDIAL_EXPORT AxisCoverage measureCoverage(const TriangleMesh& mesh, const MedialModel& model,
  double reach, const CoverageOptions& options = {});

} // namespace medial
