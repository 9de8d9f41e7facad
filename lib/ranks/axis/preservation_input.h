#pragma once

#include "base/run.h"
#include "medial/compute_medial_axis.h"
#include "medial/ranks.h"
#include "ranks/field/field_part.h"
#include "ranks/field/grid_share.h"
#include "ranks/field/rank_field.h"

namespace medial
{

/// What the steps of an axis with preserved topology need; all must outlive them.
struct PreservationInput
{
  Communicator& communicator;
  RankField& field;
  const GridShare& share; ///< of the axis
  const Grid& grid;
  const MedialAxisOptions& options;
  const Run& run;
  Side side;         ///< Both without a sign
  FieldPart& values; ///< in the rank's part of the axis and a layer behind it
};

} // namespace medial
