#pragma once

#include "field/engines/rasteriser/slab_readback.h"
#include "field/field_pipeline.h"

#include <cstdint>
#include <future>
#include <memory>
#include <vector>

// What the two ways to compute a field share.
namespace medial
{

/// A slab on its way through the pipeline.
struct FieldPipeline::Slab
{
  Extent extent;
  int previousSlices = 0; ///< of the slab below; 0 for the first
  FieldArrays arrays;
  std::vector<CandidateTiles> tiles;
  std::vector<PolygonChunk> chunks;
  std::unique_ptr<SlabReadback> readback; ///< null where nothing is wanted
};

/// A job of the GPU thread, waited for before what it works on goes away.
struct FieldPipeline::InFlight
{
  std::future<void> job;

  ~InFlight()
  {
    if (job.valid())
    {
      job.wait();
    }
  }
  /// @throws what the job threw.
  void finish()
  {
    if (job.valid())
    {
      job.get();
    }
  }
};

} // namespace medial
