#pragma once

#include "axis/axis_geometry.h"
#include "thinning/thinned_axis.h"

namespace medial
{

/// Takes the zigzag of voxels out of the curves of a thinned axis: their points move to where the
/// distance is largest in the cross-section, and a parabola is fitted to those around each of
/// them. Where curves meet sheets or each other they stay. Curves of fewer than four points have
/// no zigzag, and stay.
///
/// Only points move, so the topology stays.
void finishCurves(const AxisGeometry& geometry, ThinnedAxis& axis);

} // namespace medial
