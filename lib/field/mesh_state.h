#pragma once

#include "field/field_engine.h"
#include "sign/surface_orientation.h"

#include <memory>

namespace medial
{

/// What stays from job to job over one mesh whose points move.
struct MeshState
{
  std::unique_ptr<FieldEngine> engine; ///< of the last job; null before the first
  SurfaceOrienter orienter;
};

} // namespace medial
