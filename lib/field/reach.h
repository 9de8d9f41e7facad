#pragma once

#include "field/field_job.h"

namespace medial
{

/// Checks that no grid point can be too far from the surface for engines that compute in single
/// precision on a device.
/// @throws Error InvalidInput.
void requireNear(const FieldJob& job);

} // namespace medial
