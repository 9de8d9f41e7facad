#pragma once

#include "bodies.h"

#include "medial/proximity.h"

#include <cmath>
#include <vector>

namespace medial::app
{

/// Whether the closest points of a pair are known: they are not for pairs that do not intersect
/// with --no-separation.
inline bool hasWitnesses(const Proximity& pair)
{
  return !std::isnan(pair.separation);
}

/// What was computed of one frame.
struct FrameResult
{
  /// Those that are not farther apart than --max-separation, without depthsOfA and depthsOfB.
  std::vector<Proximity> pairs;
  double seconds = 0.0; ///< wall-clock time of all pairs
};

/// What a run computes, and what it computes it from.
struct ProximityResults
{
  std::vector<Body> bodies;
  std::vector<FrameResult> frames;
  double readSeconds = 0.0;
  double computeSeconds = 0.0;
};

} // namespace medial::app
