#pragma once

#include "base/run.h"
#include "medial/medial_axis.h"

#include <cstdint>

namespace medial
{

/// simplifyAxis() as a part of a longer operation.
MedialAxis simplifyAxis(const MedialAxis& axis, std::int64_t maxSpheres, const Run& run);

} // namespace medial
