#pragma once

#include "pairs/moving_pair.h"
#include "pairs/pair_registry.h"

#include <string>
#include <vector>

namespace medial::benchmark
{

/// What a method did in the frames of a pair.
struct PairRun
{
  std::string id, name;
  std::vector<PairQuestion> questions;
  std::vector<std::vector<double>> update; ///< seconds by round and frame
  std::vector<std::vector<double>> query;  ///< seconds by round and frame
  std::vector<PairAnswer> answers;         ///< by frame

  /// Median of the rounds, of update and query together, by frame.
  std::vector<double> frameSeconds() const;
};

/// Lets the methods take turns frame by frame, in so many rounds through all frames. A round before
/// the first, of a few frames, is not counted.
std::vector<PairRun> racePairs(const MovingPair& pair, const std::vector<PairMethodEntry>& methods,
  int rounds);

/// Median over the frames where the meshes collide as `truth` has it, or do not.
double medianWhere(const std::vector<double>& seconds, const PairRun& truth, bool colliding);

/// How the answers of a run differ from those of another.
struct PairDifference
{
  int wrongCollisions = 0;    ///< frames
  double separation = 0.0;    ///< greatest difference, as a share of the meshes' size, which is 1
  double pointDepth = 0.0;    ///< the same
  double depthRatio = 0.0;    ///< median of depth over the other's, where both collide; NaN if none
  bool hasCollisions = false; ///< whether the run tells of collisions
  bool hasSeparation = false; ///< of separations
  bool hasPointDepth = false; ///< of depths of points
};

PairDifference compareAnswers(const PairRun& run, const PairRun& truth);

} // namespace medial::benchmark
