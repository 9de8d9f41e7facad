#pragma once

#include "culling/closest_seeds.h"
#include "field/engines/rasteriser/slab_renderer.h"
#include "gl/gpu_thread.h"

#include <memory>

namespace medial
{

/// What pipelines over one mesh, in other positions each time, hand on from frame to frame.
struct FieldMemory
{
  ClosestSeeds seeds;                                      ///< of the last frame
  std::unique_ptr<gl::OnGpuThread<SlabRenderer>> renderer; ///< null before the first that draws
};

} // namespace medial
