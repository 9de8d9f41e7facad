#pragma once

#include "medial/compute_medial_axis.h"
#include "medial/ranks.h"
#include "ranks/axis/rank_part.h"

namespace medial
{

/// What the steps of an axis with preserved topology need; all must outlive them.
struct PreservationInput
{
  Communicator& communicator;
  const RankPart& part;
  const Grid& grid;
  const MedialAxisOptions& options;
  Side side; ///< Both without a sign
};

} // namespace medial
