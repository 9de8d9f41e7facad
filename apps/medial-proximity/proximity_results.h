#pragma once

#include "bodies.h"

#include "medial/proximity.h"

#include <vector>

namespace medial::app
{

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
