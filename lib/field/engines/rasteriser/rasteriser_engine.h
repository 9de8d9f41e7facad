#pragma once

#include "field/engines/rasteriser/slab_renderer.h"
#include "field/field_engine.h"
#include "gl/gpu_thread.h"

#include <memory>
#include <string>
#include <vector>

namespace medial
{

/// The method of the paper: OpenGL clips polygons that bound Voronoi regions, and draws them with
/// its depth test.
class RasteriserEngine : public FieldEngine
{
public:
  /// Starts the GPU thread if necessary.
  /// @param device as DistanceFieldOptions::device.
  /// @throws Error NoGpu.
  explicit RasteriserEngine(const std::string& device);

  Engine kind() const override { return Engine::Rasteriser; }
  std::optional<Device> device() const override { return thread_.device(); }

  void run(const FieldJob& job, FieldSink& sink) override;
  std::vector<Crossing> select(const FieldJob& job, const CrossingSelection& selection,
    FieldSink& sink) override;

private:
  using Renderer = gl::OnGpuThread<SlabRenderer>;

  /// Calls draw(renderer).
  template <typename Draw>
  void drawOn(const AtlasLayout& atlas, const FieldJob& job, const Draw& draw);
  AtlasLayout chooseAtlas(const FieldJob& job, const FieldSink& sink) const;
  Renderer& obtainRenderer(const FieldJob& job, const AtlasLayout& atlas);

  gl::GpuThread& thread_;
  std::unique_ptr<Renderer> renderer_; ///< of the last job; null before
};

} // namespace medial
