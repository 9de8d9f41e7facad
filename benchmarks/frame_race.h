#pragma once

#include "animation.h"
#include "measurement.h"

#include <memory>
#include <vector>

namespace medial::benchmark
{

/// What is computed in every frame.
enum class FrameTask
{
  Field, ///< unsigned distances and closest sites
  Axis   ///< the medial axis, with the library's defaults
};

/// The ways to do so, by their names in results.
constexpr char kSolverId[] = "solver"; ///< MedialSolver, which keeps what frames share
constexpr char kFreshId[] = "fresh";   ///< connectivity and everything else anew

/// What the two ways took for an animation.
struct FrameRace
{
  MethodRun solver;           ///< a sample a round: mean seconds a frame
  MethodRun fresh;            ///< its ratios are to the solver
  double maxDifference = 0.0; ///< between the two: of distances in voxels, or of the number of
                              ///< the axis's points as a share
};

/// Lets both ways take turns frame by frame, in so many rounds. Each round has a new solver, whose
/// first frame includes its construction.
FrameRace raceFrames(const Animation& animation, const Grid& grid, FrameTask task, int rounds);

} // namespace medial::benchmark
