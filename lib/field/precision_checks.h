#pragma once

#include "field/field_job.h"

namespace medial
{

/// Refuses what single precision cannot hold in local coordinates.
/// @param bounds of the mesh, world units.
/// @throws Error InvalidInput for a grid or mesh that reaches too far.
void requireSinglePrecision(const Bounds& bounds, const GridFrame& frame);

/// Checks that no grid point can be too far from the surface for engines that compute in single
/// precision on a device.
/// @throws Error InvalidInput.
void requireNear(const FieldJob& job);

} // namespace medial
