#pragma once

#include "base/checkpoint.h"
#include "base/run.h"
#include "medial/compute_medial_axis.h"
#include "ranks/axis_patch.h"
#include "ranks/corner_numbers.h"
#include "ranks/grid_share.h"
#include "ranks/rank_field.h"

namespace medial
{

/// What ranks need to straighten curves; all must outlive it.
struct CurveContext
{
  Communicator& communicator;
  RankField& field;
  const GridShare& share; ///< of the axis
  const MedialAxisOptions& options;
  const Run& run;
  const Checkpoint& checkpoint;
};

/// Takes the zigzag out of the curves of an axis, as finishCurves() does in one process. A curve
/// is straightened as a whole, where its middle is: that rank brings what can be closest around it,
/// instead of what was here. Every rank calls it.
/// @param patch has all lines of the axis, and the quads that they touch; its sites have their
///   numbers in the whole surface. Its points move on the first rank.
void straightenCurves(const CurveContext& context, const CornerNumbers& corners, AxisPatch& patch);

} // namespace medial
