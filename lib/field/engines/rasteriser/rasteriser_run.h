#pragma once

#include "base/checkpoint.h"
#include "field/engines/rasteriser/rasteriser_selection.h"
#include "field/engines/rasteriser/slab_readback.h"
#include "field/engines/rasteriser/slab_renderer.h"
#include "field/field_job.h"
#include "field/field_writer.h"
#include "gl/gpu_thread.h"
#include "medial/distance_field.h"

#include <array>
#include <future>
#include <memory>
#include <vector>

namespace medial
{

/// One job of the rasteriser. While the GPU works on a slab, the processor stores the previous one.
class RasteriserRun
{
public:
  using Renderer = gl::OnGpuThread<SlabRenderer>;

  /// @param renderer already has the positions of the job.
  RasteriserRun(const FieldJob& job, Renderer& renderer, FieldSink& sink);
  /// Waits for the GPU.
  ~RasteriserRun();
  RasteriserRun(const RasteriserRun&) = delete;
  RasteriserRun& operator=(const RasteriserRun&) = delete;

  /// Computes all slabs. To be called once.
  /// @param selection processes every slab on the GPU; may be null.
  void compute(RasteriserSelection* selection);

private:
  using Readback = gl::OnGpuThread<SlabReadback>;

  struct Slab
  {
    Extent extent;
    int previousSlices = 0;             ///< of the slab below; 0 for the first
    std::unique_ptr<Readback> readback; ///< null if no array is wanted
  };

  void allocateReadbacks(int slices);
  void render(SlabRenderer& renderer, Slab& slab, RasteriserSelection* selection);
  void repair(SlabRenderer& renderer, const Slab& slab) const;
  void finishRendering();
  void store(const Slab& slab);

  const FieldJob& job_;
  Renderer& renderer_;
  FieldSink& sink_;
  AtlasLayout atlas_;
  FieldWriter writer_;
  FieldArrays firstArrays_; ///< of the first slab, requested before it is computed
  std::array<Slab, 2> ring_;
  std::future<void> rendering_;
  RunStatistics::Seconds gpuSeconds_; ///< time spent on the GPU thread
  std::int64_t fragments_ = 0;        ///< counted there
  SiteRectangles::Counts counts_;     ///< counted there
};

} // namespace medial
