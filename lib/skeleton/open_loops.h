#pragma once

#include "skeleton/curve_fire.h"
#include "skeleton/curve_graph.h"

namespace medial
{

/// Removes edges that leave the solid, as long as others connect their ends: voxels touch across a
/// gap. Those of detours stay, which a curve makes through the surface and back where a ball of the
/// solid joins its parts.
void openLoops(CurveGraph& graph, const NetworkInput& input);

} // namespace medial
