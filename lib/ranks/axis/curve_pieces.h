#pragma once

#include "base/checkpoint.h"
#include "ranks/axis/axis_patch.h"
#include "ranks/axis/corner_numbers.h"
#include "ranks/axis/preservation_input.h"

namespace medial
{

/// Takes the zigzag out of the curves of an axis, as finishCurves() does in one process. A curve
/// is straightened as a whole, where its middle is: that rank brings what can be closest around it,
/// instead of what was here. Every rank calls it.
/// @param patch has all lines of the axis, and the quads that they touch; its sites have their
///   numbers in the whole surface. Its points move on the first rank.
void straightenCurves(const PreservationInput& input, const CornerNumbers& corners,
  const Checkpoint& checkpoint, AxisPatch& patch);

} // namespace medial
